// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/contact/stress/cauchy_integral.hpp"

#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/contact/enclosure/ball_values.hpp"
#include "edgeproof/precision/ball/magnitude.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace edgeproof::contact {
namespace {

/// A place in the variable omega, |omega| <= 1, of zeta = c + (D/4)(omega + 1/omega): it is 0 far
/// from the contact, and on the unit circle on the contact.
struct Outside {
    Outside(const Extent<Ball>& e, const Box& zeta) : Outside(e, zeta, root_outside(e, zeta)) {}
    Outside(const Extent<Ball>& e, const Box& zeta, const Box& W)
        : half(e.length() / 2), root(W),
          // omega = (zeta - c - W)/(D/2), without cancellation
          omega(Box(half) / (zeta - (e.a - e.b) / 2 + root)) {}
    Ball half; ///< D/2
    Box root;  ///< W
    Box omega;
};

Box unit_vector(const Mark<Ball>& v, const Ball& half) { return {v.y / half, v.w / half}; }

/// k(zeta, v) = -i ln((1 - omega e^(-ih))/(1 - omega e^(ih))): 2/E* times the Cauchy integral of
/// the pressure for a unit jump of g' at v (docs/stress.md, "A jump of the slope").
Box kernel(const Outside& at, const Mark<Ball>& v) {
    const Box e = unit_vector(v, at.half);
    if (arb_is_zero(at.omega.imaginary().data()) != 0) { // outside the contact: exactly real
        const Ball omega = at.omega.real();
        return Box(atan2(omega * v.w / at.half, 1 - omega * v.y / at.half) * 2);
    }
    return -times_i(log1p(-(at.omega * conj(e))) - log1p(-(at.omega * e)));
}

/// Bounds |(v - zeta) k| where the box of v - zeta contains zero: there |1 - omega e^(ih)| >=
/// 2 |omega| |v - zeta|/D, so that |k| <= pi + ln 2 - ln(2 |omega| r/D), r = |v - zeta|; the
/// product with r increases in r up to D/(2 e |omega|).
Box small_moment(const Outside& at, const Box& offset) {
    const long bits = offset.bits();
    const Ball r(abs(offset).upper(), bits);
    const Ball part = abs(at.omega) * r / at.half;
    Ball most(0, bits);
    if (certainly_less(part * 3, Ball(1, bits))) {
        most = certainly_positive(part)
                   ? r * (Ball::pi(bits) + log(Ball(2, bits)) - log(Ball(part.lower(), bits)))
                   : most;
    } else {
        most = unknown_ball(bits);
    }
    const Ball all = Ball::hull(-most, most);
    return {all, all};
}

/// 2/E* times T, and T' in two parts, of which one is divided by W (docs/stress.md, "Piecewise
/// linear slopes"). With a depth (length) the first part is multiplied by it, also where it is
/// infinite: z <= |v - zeta|.
struct LinearSums {
    Box value;
    Box derivative;
    Box by_root;
};

LinearSums linear_sums(const BallContact& contact, const Outside& at, const Box& zeta,
                       const std::optional<Ball>& depth) {
    const LinearSlope<Ball>& slope = contact.slope();
    // For the whole contact: (D/2) omega times the integral of g'' dh.
    const Box arc = at.omega * (contact.arc() * at.half);
    LinearSums sum{arc, Box(zeta.bits()), -arc};
    for (const std::size_t i : contact.bends_inside()) {
        const Mark<Ball>& v = contact.knot_marks()[i];
        const Ball drop = slope.rate_drop(i);
        const Box offset = slope.knots[i] - zeta;
        const Box k = kernel(at, v);
        const bool far = k.is_finite() && !offset.contains_zero();
        const Box moment = far ? offset * k : small_moment(at, offset);
        if (slope.has_corner(i)) {
            sum.value = sum.value + k * slope.jump(i);
            sum.by_root = sum.by_root + Box(slope.jump(i) * v.w) / offset;
        }
        sum.value = sum.value + (moment + v.w) * drop;
        sum.by_root = sum.by_root + drop * v.w;
        sum.derivative = sum.derivative - (!depth ? k : far ? k * *depth : moment) * drop;
    }
    return sum;
}

CauchyIntegral of_linear(const BallContact& contact, const Box& zeta) {
    const Outside at({contact.a(), contact.b()}, zeta);
    const LinearSums sum = linear_sums(contact, at, zeta, {});
    const Ball factor = contact.modulus() / 2;
    return {sum.value * factor, (sum.derivative + sum.by_root / at.root) * factor};
}

} // namespace

Box box_of_size(const Ball& x) {
    const Ball all = Magnitude(x).ball(x.bits());
    return {all, all};
}

namespace {

/// sqrt(x) for x with Im x >= 0, also if the box contains 0.
Box root_above(const Box& x) {
    if (!x.contains_zero()) {
        return sqrt(x);
    }
    const Ball most = sqrt(Ball(abs(x).upper(), x.bits()));
    const Ball part = Ball::hull(Ball(0, x.bits()), most);
    return {part, part};
}

} // namespace

Box root_above(const Extent<Ball>& e, const Box& zeta) {
    return root_above(zeta - e.a) * root_above(zeta + e.b);
}

Box depth_over_root(const Extent<Ball>& e, const Box& zeta) {
    const Box right = zeta - e.a;
    const Box left = zeta + e.b;
    if (!right.contains_zero() && !left.contains_zero()) {
        const Box ratio = Box(zeta.imaginary()) / root_above(e, zeta);
        if (ratio.is_finite()) {
            return ratio;
        }
    }
    const auto least_root = [](const Box& x) {
        const Ball least(abs(x).lower(), x.bits()); // may be below 0 where x may be 0
        return certainly_positive(least) ? sqrt(least) : Ball(0, x.bits());
    };
    return box_of_size(sqrt(Ball(zeta.imaginary().upper(), zeta.bits())) /
                       max(least_root(right), least_root(left)));
}

namespace {

// The derivatives of docs/stress.md, "Piecewise linear slopes", with omega' = -omega/W,
// k' = -w_v/(W (zeta - v)) and W' = (zeta - c)/W.
CauchyDerivatives linear_derivatives(const BallContact& contact, const Box& zeta) {
    const long bits = zeta.bits();
    const Extent<Ball> e{contact.a(), contact.b()};
    const Outside at(e, zeta, root_above(e, zeta));
    const LinearSums sums = linear_sums(contact, at, zeta, {});
    const Box inverse = Box(Ball(1, bits)) / at.root;
    const Box ratio = (zeta - (e.a - e.b) / 2) * inverse * inverse; // -W (1/W)'
    CauchyDerivatives sum{sums.value, sums.derivative + sums.by_root * inverse, Box(bits),
                          Box(bits)};
    for (const std::size_t i : contact.bends_inside()) {
        const Ball weight = contact.slope().rate_drop(i) * contact.knot_marks()[i].w;
        const Box pole = Box(Ball(1, bits)) / (zeta - contact.slope().knots[i]);
        sum[2] = sum[2] + pole * weight;
        sum[3] = sum[3] - (ratio + pole) * pole * weight;
    }
    const Box arc = at.omega * (contact.arc() * at.half);
    const Box rate = arc * inverse; // of by_root
    const Box square = inverse * inverse;
    sum[2] = (sum[2] + rate - sums.by_root * ratio) * inverse;
    sum[3] = (sum[3] - arc * square - rate * ratio * Ball(3, bits) +
              sums.by_root * (ratio * ratio * Ball(3, bits) - square)) *
             inverse;
    for (Box& x : sum) {
        x = x * (contact.modulus() / 2);
    }
    return sum;
}

CauchyBounds linear_bounds(const BallContact& contact, const Box& zeta) {
    const Extent<Ball> e{contact.a(), contact.b()};
    const Outside at(e, zeta, root_above(e, zeta));
    const LinearSums sum = linear_sums(contact, at, zeta, zeta.imaginary());
    const Ball factor = contact.modulus() / 2;
    return {sum.value * factor, (sum.derivative + sum.by_root * depth_over_root(e, zeta)) * factor};
}

/// pi E*/2 times g'(x), x > 0, of a power law: P'(a) (x/a)^m times the integral of
/// t^m/sqrt(1 - t^2) (DLMF 5.12.2).
Ball power_law_slope(const BallContact& contact, const Ball& x) {
    const Ball& m = contact.power_law()->exponent;
    const Ball quarter =
        gamma((m + 1) / 2) / gamma(m / 2 + 1) * sqrt(Ball::pi(contact.a().bits())) / 2;
    return contact.force_rate() * pow(x / contact.a(), m) * quarter;
}

/// 2F1(1/2, power/2; power/2 + 1; ratio). The last values are kept, because a search asks for
/// several bounds over the same box.
Box punches(const Ball& power, const Box& ratio) {
    struct Value {
        Ball power;
        Box ratio;
        Box value;
    };
    constexpr std::size_t most_kept = 8;
    thread_local std::vector<Value> kept;
    thread_local std::size_t next = 0;
    for (const Value& known : kept) {
        if (known.ratio.bits() == ratio.bits() &&
            arb_equal(known.power.data(), power.data()) != 0 &&
            acb_equal(known.ratio.get(), ratio.get()) != 0) {
            return known.value;
        }
    }
    const Ball half(Rational(1, 2), ratio.bits());
    Value now{power, ratio, hypergeometric_2f1(half, power / 2, power / 2 + 1, ratio)};
    if (kept.size() < most_kept) {
        kept.push_back(now);
    } else {
        kept[next++ % most_kept] = now;
    }
    return now.value;
}

/// m, if it is a whole number for which the recurrence below is short; else 0.
long whole_exponent(const Ball& m) {
    constexpr long most = 64;
    return arb_is_int(m.data()) != 0 && certainly_less(m, Ball(most + 1, m.bits()))
               ? std::lround(arf_get_d(arb_midref(m.data()), ARF_RND_NEAR))
               : 0;
}

/// The integral of u^m/sqrt(Z^2 - u^2) over 0 < u < 1, Re Z >= 0, by the recurrence
/// m J_m = (m - 1) Z^2 J_(m-2) - sqrt(Z^2 - 1), which follows by integration by parts. It loses
/// m ln|Z| where |Z| > 1. `root` is sqrt(Z^2 - 1).
Box punches_of_whole_power(long m, const Box& Z, const Box& root) {
    const long bits = Z.bits();
    const Box Z2 = Z * Z;
    Box J = Z - root; // m = 1
    if (m % 2 == 0) {
        const Box inverse = Box(Ball(1, bits)) / Z;
        acb_asin(J.get(), inverse.get(), bits);
    }
    for (long k = m % 2 == 0 ? 2 : 3; k <= m; k += 2) {
        J = (Z2 * J * Ball(k - 1, bits) - root) / Ball(k, bits);
    }
    return J;
}

// P(a) = K a^(m+1), so that the Cauchy integral is that of the flat punches by which the contact
// grows: the integral of P'(s)/sqrt(zeta^2 - s^2) ds over 0 < s < a (docs/stress.md, "Power laws").
CauchyIntegral of_power_law(const BallContact& contact, const Box& zeta) {
    const long bits = zeta.bits();
    const Ball& a = contact.a();
    const Ball force = contact.force();
    const Ball growth = contact.force_rate() * a; // a P'(a)
    // Exact where m is: 2F1 is degenerate for even m.
    const Ball power = contact.power_law()->exponent + 1;
    const Box root = root_outside({a, a}, zeta);
    const Ball x = abs(zeta.real());
    const bool surface = arb_is_zero(zeta.imaginary().data()) != 0;
    Box value(bits);
    if (surface && !certainly_less(a, x)) {
        value = Box(power_law_slope(contact, x),
                    -Ball::pi(bits) * contact.pressure(Edge::right, a - x));
    } else {
        // Where Re zeta > 0 the branch of 2F1 is the principal one.
        const Box right = certainly_negative(zeta.real()) ? -conj(zeta) : zeta;
        const long whole = whole_exponent(power - 1);
        const bool near = certainly_less(abs(right) * 2, a * 3);
        value = whole > 0 && near
                    ? punches_of_whole_power(whole, right / a, root_outside({a, a}, right) / a) *
                          (growth / a)
                    : punches(power, Box(a * a) / (right * right)) * force / right;
    }
    if (certainly_negative(zeta.real())) {
        value = -conj(value);
    }
    // value is homogeneous in zeta and a, of degree m.
    return {value, (value * (power - 1) - Box(growth) / root) / zeta};
}

// docs/stress.md, "The greatest values": zeta T' = m T - a P'(a)/W bounds T' over the box by its
// own size, and then gives all derivatives.
CauchyDerivatives power_law_derivatives(const BallContact& contact, const Box& zeta) {
    const long bits = zeta.bits();
    const Ball growth = contact.force_rate() * contact.a();
    const Ball& m = contact.power_law()->exponent;
    const Extent<Ball> e{contact.a(), contact.a()};
    const Box middle = zeta.middle();
    const Box offset = zeta - middle;
    const Ball r(abs(offset).upper(), bits);
    const Box root = root_above(e, zeta);
    const Ball left = Ball(abs(zeta).lower(), bits) - m * r;
    if (!certainly_positive(left) || root.contains_zero()) {
        const Box unknown(unknown_ball(bits), unknown_ball(bits));
        return {unknown, unknown, unknown, unknown};
    }
    const Box start = of_power_law(contact, middle).value;
    const Box inverse = Box(Ball(1, bits)) / root;
    const Box free = inverse * growth;
    const auto rate_of = [&](const Box& value) { return (value * m - free) / zeta; };
    const Ball most = (m * abs(start) + abs(free)) / left; // of |T'|
    const Box value = start + offset * rate_of(start + box_of_size(most * r));
    const Box first = rate_of(value);
    const Box cube = free * inverse * inverse;
    const Box second = first * (m - 1) / zeta + cube;
    const Box third =
        (second - first / zeta) * (m - 1) / zeta - cube * inverse * inverse * zeta * Ball(3, bits);
    return {value, first, second, third};
}

CauchyBounds power_law_bounds(const BallContact& contact, const Box& zeta) {
    const long bits = zeta.bits();
    const Ball& a = contact.a();
    const Ball growth = contact.force_rate() * a;
    const Ball& m = contact.power_law()->exponent;
    const Extent<Ball> e{a, a};
    const CauchyDerivatives regular = power_law_derivatives(contact, zeta);
    if (regular[1].is_finite()) {
        return {regular[0], regular[1] * zeta.imaginary()};
    }
    const auto least = [bits](const Box& x) { return Ball(abs(x).lower(), bits); };
    const auto most = [bits](const Box& x) { return Ball(abs(x).upper(), bits); };
    const Box right = zeta - a;
    const Box left = zeta + a;
    if (right.contains_zero() || left.contains_zero()) {
        // The integral of |T'| along a line to the edge; that of 1/sqrt|zeta - a| is 2 sqrt(r).
        const bool at_right = right.contains_zero();
        const Ball end = power_law_slope(contact, a);
        const Ball r = most(at_right ? right : left);
        const Ball change =
            (r * m * end + growth * sqrt(r) * 2 / sqrt(least(at_right ? left : right))) /
            clamped(least(zeta) - m * r);
        const Box value = box_of_size(change) + (at_right ? end : -end);
        return {value, (value * m * zeta.imaginary() - depth_over_root(e, zeta) * growth) / zeta};
    }
    // Near the origin, by the size of zeta T' on |zeta| = a/2 and its equation along a ray.
    const Ball part = most(zeta) * 2 / a;
    if (certainly_less(Ball(1, bits), part)) {
        return {regular[0], regular[1]};
    }
    const Ball three(3, bits);
    const Ball scale = growth / a;
    const Ball on_circle =
        scale * (m * (Ball::pi(bits) / 2 + acosh(Ball(2, bits))) + 2 / sqrt(three));
    const Box moment = box_of_size(on_circle * pow(part, m) + scale * 2 / (three * sqrt(three)) *
                                                                  pow(part, min(m, Ball(1, bits))));
    return {(moment + Box(growth) / root_above(e, zeta)) / m, moment};
}

} // namespace

Box root_outside(const Extent<Ball>& e, const Box& zeta) {
    return sqrt(zeta - e.a) * sqrt(zeta + e.b);
}

Ball distance_from(const Extent<Ball>& e, const Box& zeta) {
    const Ball zero(0, zeta.bits());
    const Ball across = max(zero, max(zeta.real() - e.a, -e.b - zeta.real()));
    return max(zero, Ball(hypot(across, zeta.imaginary()).lower(), zeta.bits()));
}

CauchyIntegral BallContact::cauchy_integral(const Box& zeta,
                                            const std::optional<Exact>& /*x*/) const {
    return piecewise_linear() ? of_linear(*this, zeta) : of_power_law(*this, zeta);
}

std::vector<Ball> BallContact::edge_slope(std::size_t terms) const {
    std::vector<Ball> E(terms, Ball(0, bits_));
    if (!piecewise_linear()) { // the binomial series of (zeta/a)^m
        E[0] = power_law_slope(*this, a_);
        for (std::size_t k = 1; k < terms; ++k) {
            const auto n = static_cast<long>(k);
            E[k] = E[k - 1] * (power_->exponent - (n - 1)) / (a_ * n);
        }
        return E;
    }
    // g'(a) = (1/pi) integral of (pi - h) dg' by the consistency condition
    E[0] = over_linear_measure<LeftBalanceKernel>(slope_, Extent<Ball>{a_, b_}, fixed_.marks) *
           modulus_ / 2;
    if (terms > 1) {
        const auto beyond =
            std::ranges::find(fixed_.marks, std::optional(Edge::right), &Mark<Ball>::end);
        E[1] = slope_.rate(static_cast<std::size_t>(beyond - fixed_.marks.begin())) * modulus_ *
               Ball::pi(bits_) / 2;
    }
    return E;
}

Box BallContact::edge_slope_rate(const Ball& radius) const {
    const Ball rate = edge_slope(2)[1];
    if (piecewise_linear()) {
        return Box(rate);
    }
    // (m/a) T(a) (zeta/a)^(m-1), |zeta/a - 1| at most q
    const Ball& m = power_->exponent;
    const Ball q = radius / a_;
    const Ball change = abs(m - 1) * q * max(pow(1 - q, m - 2), pow(1 + q, m - 2));
    return (box_of_size(change) + Ball(1, bits_)) * rate;
}

CauchyDerivatives BallContact::cauchy_derivatives(const Box& zeta) const {
    return piecewise_linear() ? linear_derivatives(*this, zeta)
                              : power_law_derivatives(*this, zeta);
}

CauchyBounds BallContact::cauchy_bounds(const Box& zeta) const {
    return piecewise_linear() ? linear_bounds(*this, zeta) : power_law_bounds(*this, zeta);
}

// docs/stress.md, "The Cauchy integrals of q": T = Q/W + (pi sigma_0/4)((zeta - c)/W - 1)
CauchyIntegral cauchy_integral(const Extent<Ball>& e, const ShearLoad<Ball>& load,
                               const Box& zeta) {
    const Outside at(e, zeta);
    const Ball tension = load.bulk_tension * Ball::pi(zeta.bits()) / 4;
    const Box lead = zeta - (e.a - e.b) / 2;
    return {(at.omega * (tension * at.half) + load.Q) / at.root,
            -(lead * load.Q + tension * at.half * at.half) / (at.root * at.root * at.root)};
}

} // namespace edgeproof::contact
