// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/stress/edge_stress.hpp"

#include "edgeproof/contact/enclosure/ball_values.hpp"
#include "edgeproof/contact/enclosure/isolate_zero.hpp"
#include "edgeproof/formula/exact/enclosure.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"

#include <algorithm>
#include <cmath>

namespace edgeproof::contact {
namespace {

constexpr std::size_t most_ray_intervals = 20'000;
constexpr long lost_at_crossing = 48; ///< bits

/// The Taylor coefficients at x = `at` of the Cauchy integral of the pressure of a zone to the left
/// of it, by the trapezoidal rule on a circle. If |f| <= most inside the circle of the radius rho,
/// then |a_k| <= most/rho^k, and n points on the circle of the radius q rho give a_k with an error
/// of at most most/rho^k q^n/(1 - q^n) (`trefethen-weideman2014`, theorem 2.1).
std::vector<Ball> taylor_at(const BallContact& zone, const Ball& at, const Ball& rho,
                            const Ball& most, std::size_t terms) {
    const long bits = rho.bits();
    const Ball q = Ball(3, bits) / 4;
    const std::size_t half = std::max(terms, static_cast<std::size_t>(bits) * 5 / 4 + 1);
    const std::size_t n = 2 * half; // q^n < 2^-bits
    const Ball r = rho * q;
    const auto on_circle = [&](std::size_t j) {
        Ball c(0, bits);
        Ball s(0, bits);
        const Rational part(static_cast<long>(j), static_cast<long>(half));
        arb_sin_cos_pi(s.data(), c.data(), Ball(part, bits).data(), bits);
        return j == half ? Box(Ball(-1, bits)) : Box(c, s);
    };
    std::vector<Box> unit;
    std::vector<Box> f;
    for (std::size_t j = 0; j <= half; ++j) {
        unit.push_back(on_circle(j));
        // f is real on the axis, so that the lower half of the circle has the conjugate values.
        f.push_back(cauchy_integral(zone, unit[j] * r + at).value *
                    Ball(j == 0 || j == half ? 1 : 2, bits));
    }
    const Ball error =
        up_to(most * pow_int(q, static_cast<long>(n)) / (1 - pow_int(q, static_cast<long>(n))));
    std::vector<Ball> a;
    for (std::size_t k = 0; k < terms; ++k) {
        Ball sum(0, bits);
        for (std::size_t j = 0; j <= half; ++j) {
            const std::size_t turned = j * k % n;
            const Box w = turned <= half ? conj(unit[turned]) : unit[n - turned];
            sum += (f[j] * w).real();
        }
        const auto power = static_cast<long>(k);
        a.push_back(sum / static_cast<long>(n) / pow_int(r, power) + error / pow_int(rho, power));
    }
    return a;
}

} // namespace

EdgeStress::EdgeStress(const StressField& field, const std::optional<ShearLoad<Ball>>& stick,
                       Edge edge, std::size_t terms)
    : bits_(field.bits()), first_(stick ? -1 : 0), edge_(edge), bulk_(field.bulk),
      pressure_(terms, Ball(0, bits_)), shear_(terms, Ball(0, bits_)), most_(0, bits_) {
    const StressField turned = edge == Edge::left ? field.reflected() : field;
    const BallContact& contact = turned.contact();
    Ball reach(contact.reach(Edge::right).lower(), bits_);
    for (std::size_t i = 1; i < turned.parts.size(); ++i) {
        reach = min(reach, contact.a() - turned.parts[i].contact.a());
    }
    radius_ = Ball(Real((reach * 31 / 32).lower()), bits_);
    if (!certainly_positive(radius_) || contact.edge_may_be_on_knot()) {
        throw BudgetError("too few bits to separate the edge from a knot or from a stick zone");
    }
    add_contact(contact, turned.parts.front().pressure, turned.parts.front().shear);
    for (std::size_t i = 1; i < turned.parts.size(); ++i) {
        add_zone(turned.parts[i].contact, contact.a(), turned.parts[i].shear);
    }
    if (stick) { // the mirror image of q has the other sign, that of a tension the same
        add_stick({edge == Edge::left ? -stick->Q : stick->Q, stick->bulk_tension},
                  contact.length());
    }
}

// P is pi E* g'/2 - pi sum (-1)^k c_k s^(2k+1), with g' of the piece that ends at the edge.
void EdgeStress::add_contact(const BallContact& contact, const Ball& pressure, const Ball& shear) {
    const Ball pi = Ball::pi(bits_);
    const auto terms = static_cast<int>(pressure_.size());
    const auto add = [&](int j, const Ball& A) {
        if (j - first_ < terms) {
            pressure_[entry(j)] += A * pressure;
            shear_[entry(j)] += A * shear;
        }
    };
    const std::vector<Ball> c = contact.expansion(Edge::right, pressure_.size() / 2 + 1);
    for (std::size_t k = 0; k < c.size(); ++k) {
        add(static_cast<int>(2 * k + 1), k % 2 == 0 ? -pi * c[k] : pi * c[k]);
    }
    Ball A = cauchy_integral_at_edge(contact, Edge::right);
    add(0, A);
    Ball slope = abs(A); // a bound of the terms of g'
    if (contact.piecewise_linear()) {
        const auto& marks = contact.knot_marks();
        const auto beyond = std::ranges::find(marks, std::optional(Edge::right), &Mark<Ball>::end);
        A = contact.slope().rate(static_cast<std::size_t>(beyond - marks.begin())) *
            contact.modulus() * pi / 2;
        add(2, A);
        slope += abs(A) * radius_;
    } else { // the binomial series of (zeta/a)^m, |coefficients| <= those of (1 - s^2/a)^-m
        const Ball& m = contact.power_law()->exponent;
        slope = slope * pow(1 - radius_ / contact.a(), -m);
        for (int k = 0; 2 * k + 2 - first_ < terms; ++k) {
            A = A * (m - k) / (contact.a() * (k + 1));
            add(2 * k + 2, A);
        }
    }
    most_ += (slope + contact.majorant(Edge::right, radius_) * sqrt(radius_) * pi) *
             (abs(pressure) + abs(shear));
}

void EdgeStress::add_zone(const BallContact& zone, const Ball& at, const Ball& shear) {
    const Ball force = zone.piecewise_linear() ? zone.zone_force() : zone.force();
    const Ball most = force / (at - zone.a() - radius_);
    const std::vector<Ball> a = taylor_at(zone, at, radius_, most, (shear_.size() + 1) / 2);
    for (std::size_t k = 0; 2 * k < shear_.size(); ++k) {
        shear_[2 * k] += a[k] * shear; // first is 0: no zones under full stick
    }
    most_ += most * abs(shear);
}

// T = -pi sigma_0/4 + pi sum (-1)^k s_k s^(2k-1); the coefficients of (1 - u/L)^(-1/2) lie between
// 0 and 1.
void EdgeStress::add_stick(const ShearLoad<Ball>& load, const Ball& length) {
    const Ball pi = Ball::pi(bits_);
    const auto s = full_stick_expansion(length, load, Edge::right, shear_.size() / 2 + 1);
    for (std::size_t k = 0; 2 * k < shear_.size(); ++k) {
        shear_[2 * k] += k % 2 == 0 ? pi * s[k] : -pi * s[k];
    }
    const Ball tension = load.bulk_tension * pi / 4;
    if (shear_.size() > 1) {
        shear_[1] -= tension;
    }
    const Ball largest =
        (abs(load.Q) / pi + abs(load.bulk_tension) * length * 3 / 8) / sqrt(length);
    most_ += abs(tension) + largest * pi / sqrt(radius_);
}

// docs/stress.md, "Near an edge": with h = j/2 and the angle phi from the free surface
std::vector<Ball> EdgeStress::along(StressComponent component, const Exact& angle) const {
    std::optional<Rational> exact; // phi/pi
    if (angle.is_rational()) {
        exact = Rational(1 - angle.rational() / 180);
    }
    const Ball turn = exact ? Ball(*exact, bits_) : 1 - ball_of(angle, bits_) / 180;
    const auto at = [&](const Rational& h, bool sine) {
        Ball x = exact ? Ball(Rational(h * *exact), bits_) : Ball(h, bits_) * turn;
        (sine ? arb_sin_pi : arb_cos_pi)(x.data(), x.data(), bits_);
        return x;
    };
    std::vector<Ball> K;
    for (std::size_t i = 0; i < pressure_.size(); ++i) {
        const Rational h(static_cast<long>(i) + first_, 2);
        const Rational half = h / 2;
        const auto sines = [&](const Rational& u,
                               const Rational& v) { // u sin h phi + v sin (h-2) phi
            return h == 1 ? Ball(Rational(u - v), bits_) * at(h, true)
                          : Ball(u, bits_) * at(h, true) + Ball(v, bits_) * at(h - 2, true);
        };
        // h/2 (cos h phi - cos (h-2) phi), exactly 0 where it vanishes
        const Ball cosines = at(1, true) * at(h - 1, true) * Ball(-h, bits_);
        const Ball& A = pressure_[i];
        const Ball& B = shear_[i];
        Ball k = component == StressComponent::sxx
                     ? A * sines(1 + half, -half) - B * (at(h, false) * 2 + cosines)
                 : component == StressComponent::szz ? A * sines(1 - half, half) + B * cosines
                                                     : A * cosines + B * sines(1 + half, -half);
        k /= Ball::pi(bits_);
        if (component == StressComponent::sxx && h == 0) {
            k += bulk_;
        }
        K.push_back(component == StressComponent::sxz && edge_ == Edge::left ? -k : k);
    }
    return K;
}

// |K_j| <= (2 + |j|/2) (|A_j| + |B_j|)/pi, and 2 + |j|/2 <= (5 + i)/2 for the entry i
Ball EdgeStress::rest(std::size_t n, std::size_t divisor, const Ball& y) const {
    const Ball left = 1 - y;
    const auto i = static_cast<long>(n);
    return most_ / Ball::pi(bits_) * pow_int(y, i - static_cast<long>(divisor)) *
           (Ball(5 + i, bits_) / left + y / (left * left)) / 2;
}

namespace {

/// The least zero of g(y) + a rest in 0 < y <= end, where g(0) is not 0; `rest(y)` bounds the rest
/// over all places up to y. In an interval where g is monotone, values of one sign at both ends
/// that exceed the rest exclude a zero, and values of both signs enclose the least one.
template <class Rest>
std::optional<Ball> least_zero(const std::vector<Ball>& g, const Rest& rest, const Rational& end,
                               std::size_t& intervals) {
    const long bits = g.front().bits();
    std::vector<Ball> derivative{Ball(0, bits)};
    for (std::size_t k = 1; k < g.size(); ++k) {
        derivative.resize(k, Ball(0, bits));
        derivative[k - 1] = g[k] * static_cast<long>(k);
    }
    Rational lo = 0;
    Rational width = end / 16;
    while (lo < end) {
        check_interruption();
        if (++intervals > most_ray_intervals) {
            throw BudgetError("undecided: the error may touch the tolerance");
        }
        const Rational hi = std::min(Rational(lo + width), end);
        const Ball noise = up_to(rest(Ball(hi, bits)));
        const auto at = [&](const Rational& y) { return horner(g, Ball(y, bits)) + noise; };
        const Ball y = Ball::hull(Ball(lo, bits), Ball(hi, bits));
        const Ball rate = horner(derivative, y);
        const Rational m = (lo + hi) / 2;
        const Ball left = at(lo);
        const Ball right = at(hi);
        const bool decided = !contains_zero(left) && !contains_zero(right);
        const bool rises = certainly_positive(right);
        const bool same = decided && certainly_positive(left) == rises;
        const bool monotone = !contains_zero(rate) && rate.is_finite();
        if ((monotone && same) || !contains_zero(at(m) + rate * (y - Ball(m, bits)))) {
            lo = hi;
            width *= 2;
        } else if (monotone && decided) {
            const auto zero = enclosed_crossing(
                {lo, hi, rises}, bits, lost_at_crossing,
                [&](const Rational& x) {
                    return std::pair(horner(g, Ball(x, bits)), horner(derivative, Ball(x, bits)));
                },
                at);
            return zero ? *zero : y;
        } else {
            width /= 2;
        }
    }
    return {};
}

} // namespace

RayExtent ray_extent(const EdgeStress& series, StressComponent component, const Exact& angle,
                     std::size_t n, const Exact& tolerance, long accuracy) {
    std::vector<Ball> k = series.along(component, angle);
    const long bits = k.front().bits();
    const Ball root = sqrt(series.radius());
    Ball scale = series.first() < 0 ? 1 / root : Ball(1, bits);
    for (Ball& x : k) { // stresses: the coefficients of y^j, y = sqrt(r/radius)
        x *= scale;
        scale *= root;
    }
    const auto zero = [](const Ball& x) { return arb_is_zero(x.data()) != 0; };
    const auto lead =
        static_cast<std::size_t>(std::find_if_not(k.begin(), k.end(), zero) - k.begin());
    // The end: a power of 2^(1/N), as a number of few bits
    const double at_end = std::exp2(-static_cast<double>(accuracy) / static_cast<double>(k.size()));
    const Rational end = exact_value(Ball(Real(at_end), 32).midpoint());
    RayExtent found{{}, series.radius() * Ball(Rational(end * end), bits), lead >= n};
    if (found.vanishes) {
        return found;
    }
    if (contains_zero(k[lead])) {
        throw BudgetError("too few bits to separate the first term from zero");
    }
    const Ball limit = ball_of(tolerance, bits);
    std::size_t intervals = 0;
    for (const Ball& side : {limit, -limit}) {
        // sum of the terms from n on + side times the whole sum, over y^lead
        std::vector<Ball> g;
        for (std::size_t i = lead; i < k.size(); ++i) {
            g.push_back(k[i] * (i < n ? side : side + 1));
        }
        const auto rest = [&](const Ball& y) {
            return series.rest(k.size(), lead, y) * (limit + 1);
        };
        if (const auto y = least_zero(g, rest, end, intervals)) {
            const Ball r = series.radius() * *y * *y;
            found.exit = found.exit ? min(*found.exit, r) : r;
        }
    }
    return found;
}

} // namespace edgeproof::contact
