// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/contact/stress/stress_measure.hpp"

#include <algorithm>
#include <utility>

namespace edgeproof::contact {

namespace {

/// Re(conj(x) y).
Ball dot(const Box& x, const Box& y) { return x.real() * y.real() + x.imaginary() * y.imaginary(); }
Ball square_of_size(const Box& x) { return square(x.real()) + square(x.imaginary()); }

/// The box, or the box around 0 of all numbers of at most `most`, whichever is smaller.
Box within(const Box& x, const Ball& most) {
    if (!most.is_finite() || (x.is_finite() && abs(x).upper() <= most.upper())) {
        return x;
    }
    const Ball all = Ball::hull(-most, most);
    return {all, all};
}

/// [0, r] for a power of two r, with its lower end exactly 0.
Ball from_zero_to(const Ball& r) {
    Ball x = r / 2;
    mag_set_ui_2exp_si(arb_radref(x.data()), 1, mpfr_get_exp(raw(x.midpoint())) - 1);
    return x;
}

/// The Cauchy integral of a contact near its right edge, with zeta = a + s^2: T(a) + rate s^2 -
/// root s + cubic s^3 for |s|^2 at most a radius, where `rate` and `cubic` enclose functions of
/// s^2. It is pi E* g'/2 - pi sum (-1)^k c_k s^(2k+1) with the coefficients c_k of p.
struct EdgeForm {
    Ball root; ///< pi c_0
    Box rate;  ///< stress/length
    Box cubic;
    Box cubic_rate; ///< the derivative of `cubic` by s^2
};

std::optional<EdgeForm> edge_form(const PlaneContact& contact, const Ball& radius) {
    const long bits = radius.bits();
    const Ball pi = Ball::pi(bits);
    const Ball rho(Real(contact.reach(Edge::right).lower() / 2), bits);
    const Ball part = radius / rho;
    const Ball one(1, bits);
    if (!certainly_positive(rho) || !certainly_less(part * 2, one)) {
        return {};
    }
    const std::vector<Ball> c = contact.expansion(Edge::right, 2);
    const Ball most = contact.majorant(Edge::right, rho) * pi / rho; // |c_k| <= M/rho^k
    return EdgeForm{c[0] * pi, contact.edge_slope_rate(radius),
                    box_of_size(most * part / (1 - part)) + c[1] * pi,
                    box_of_size(most / rho / ((1 - part) * (1 - part)))};
}

} // namespace

Ball square(const Ball& x) {
    Ball r(0, x.bits());
    arb_sqr(r.data(), x.data(), x.bits());
    return r;
}

struct StressMeasure::Sums {
    Box D;
    Ball S;
};

StressMeasure::StressMeasure(StressField field, const StressNorm& norm)
    : field_(std::move(field)), kind_(norm.kind),
      deviator_(kind_ == Kind::mises ? 3 : 1, field_.bits()),
      mean_(kind_ == Kind::mises ? square(Ball(1 - *norm.poisson * 2)) : Ball(0, field_.bits())),
      bulk_(field_.bulk * Ball::pi(field_.bits()) / 2) {
    for (const LoadPart& part : field_.parts) {
        weights_.emplace_back(part.pressure, -part.shear);
        forces_.push_back(part.contact->force());
    }
}

Ball StressMeasure::stress(const Ball& F) const {
    return (on_surface_only() ? F : sqrt(F)) / Ball::pi(field_.bits());
}

Ball StressMeasure::measure(const Box& D, const Ball& S) const {
    return on_surface_only() ? D.real() + S : deviator_ * square_of_size(D) + mean_ * square(S);
}

bool StressMeasure::mirrored_on_surface(const Ball& x) const {
    // |D| is the same at the mirror image; S at the edges of the contact, where p = 0, has only
    // another sign.
    const auto at_edge_of_contact = [&] {
        return overlaps(x, field_.contact().a()) || overlaps(-x, field_.contact().b());
    };
    return kind_ == Kind::tau_max || (kind_ == Kind::mises && at_edge_of_contact());
}

// A part with the force F at the distance d or more has |T| <= F/d, and |z dT/dzeta| <= F z/d^2,
// z <= d.
Ball StressMeasure::far(const Ball& distance) const {
    Ball deviator = on_surface_only() ? bulk_ : abs(bulk_);
    Ball mean = deviator;
    for (std::size_t i = 0; i < weights_.size(); ++i) {
        const Ball size = forces_[i] / distance;
        const Ball shear = abs(field_.parts[i].shear);
        deviator += size * (abs(weights_[i]) + shear);
        mean += size * (abs(field_.parts[i].pressure) + shear);
    }
    return Ball(measure(Box(deviator), mean).upper(), field_.bits());
}

Ball StressMeasure::bound(const Box& zeta) const {
    const Sums at = sums(zeta);
    return measure(at.D, at.S);
}

StressMeasure::Sums StressMeasure::sums(const Box& zeta) const {
    const long bits = field_.bits();
    Box D(bulk_);
    Ball S = bulk_;
    for (std::size_t i = 0; i < weights_.size(); ++i) {
        const LoadPart& part = field_.parts[i];
        CauchyBounds bounds = part.contact->cauchy_bounds(zeta);
        const Ball d = distance_from({part.contact->a(), part.contact->b()}, zeta);
        const Ball most = forces_[i] / d;
        const Box T = within(bounds.value, most);
        const Box with_depth =
            within(bounds.with_depth, most * Ball(zeta.imaginary().upper(), bits) / d);
        D = D + with_depth * weights_[i] - T * part.shear;
        S += T.imaginary() * part.pressure - T.real() * part.shear;
    }
    return {D, S};
}

PlaneJet StressMeasure::jet(const Box& zeta) const {
    const long bits = field_.bits();
    const Ball z = zeta.imaginary();
    std::array<Box, 3> G{Box(bits), Box(bits), Box(bits)}; // P' - i T' and its derivatives
    std::array<Box, 3> T{Box(bits), Box(bits), Box(bits)};
    Ball S = bulk_;
    for (std::size_t i = 0; i < weights_.size(); ++i) {
        const LoadPart& part = field_.parts[i];
        CauchyDerivatives t = part.contact->cauchy_derivatives(zeta);
        const Ball d = distance_from({part.contact->a(), part.contact->b()}, zeta);
        Ball most = forces_[i] / d; // |d^n T/dzeta^n| <= n! F/d^(n+1)
        for (std::size_t n = 0; n < t.size(); ++n) {
            t[n] = within(t[n], most);
            most = most * static_cast<long>(n + 1) / d;
        }
        for (std::size_t n = 0; n < G.size(); ++n) {
            G[n] = G[n] + t[n + 1] * weights_[i];
            T[n] = T[n] + t[n] * part.shear;
        }
        S += t[0].imaginary() * part.pressure - t[0].real() * part.shear;
    }
    const Ball two(2, bits);
    Box D = G[0] * z - T[0] + bulk_;
    const Box D_x = G[1] * z - T[1];
    const Box D_z = G[0] - times_i(T[1]) + times_i(G[1]) * z;
    const Box D_xx = G[2] * z - T[2];
    const Box D_xz = G[1] - times_i(T[2]) + times_i(G[2]) * z;
    const Box D_zz = times_i(G[1]) * two - D_xx;
    const Ball S_x = G[0].imaginary(); // S is the real part of an analytic function
    const Ball S_z = G[0].real();      // whose derivative is -i G
    if (on_surface_only()) {
        // Sums of D and S need narrow enclosures: from the middle of the box.
        const Box middle = zeta.middle();
        const Sums at = sums(middle);
        const Ball x_off = zeta.real() - middle.real();
        const Ball z_off = z - middle.imaginary();
        const Box near = at.D + D_x * x_off + D_z * z_off;
        const Ball S_near = at.S + S_x * x_off + S_z * z_off;
        D = near.is_finite() ? near : D;
        S = S_near.is_finite() ? S_near : S;
    }
    const Ball S_xx = G[1].imaginary();
    const PlaneJet mean{S, {S_x, S_z}, {S_xx, G[1].real(), -S_xx}};
    if (on_surface_only()) {
        const Ball one(1, bits);
        return sum(one,
                   {D.real(), {D_x.real(), D_z.real()}, {D_xx.real(), D_xz.real(), D_zz.real()}},
                   one, mean);
    }
    const PlaneJet square_of_D{square_of_size(D),
                               {dot(D, D_x) * 2, dot(D, D_z) * 2},
                               {(square_of_size(D_x) + dot(D, D_xx)) * 2,
                                (dot(D_x, D_z) + dot(D, D_xz)) * 2,
                                (square_of_size(D_z) + dot(D, D_zz)) * 2}};
    return sum(deviator_, square_of_D, mean_, square(mean));
}

Ball StressMeasure::at_edge(std::size_t part, Edge edge) const {
    if (edge == Edge::left) {
        return reflected().at_edge(part, Edge::right);
    }
    const Sums at = at_right_edge(part);
    return measure(at.D, at.S);
}

StressMeasure StressMeasure::reflected() const {
    StressMeasure turned = *this;
    turned.field_ = field_.reflected();
    for (Box& w : turned.weights_) {
        w = conj(w);
    }
    return turned;
}

StressMeasure::Sums StressMeasure::at_right_edge(std::size_t part) const {
    const Box e(field_.parts[part].contact->a());
    Sums sums{Box(bulk_), bulk_};
    for (std::size_t i = 0; i < field_.parts.size(); ++i) {
        const LoadPart& other = field_.parts[i];
        const Box T = i == part ? Box(other.contact->cauchy_integral_at(Edge::right))
                                : other.contact->cauchy_integral(e).value;
        sums.D = sums.D - T * other.shear;
        sums.S += T.imaginary() * other.pressure - T.real() * other.shear;
    }
    return sums;
}

// docs/stress.md, "The greatest values": with zeta = e + s^2, s = rho e^(i phi), F - F(e) is rho
// times A(phi) + rho B(rho, phi).
bool StressMeasure::greatest_at_right_edge(std::size_t part, const Ball& radius) const {
    const long bits = field_.bits();
    const LoadPart& own = field_.parts[part];
    const Ball& p = own.pressure;
    const Ball& t = own.shear;
    const auto near = edge_form(*own.contact, radius);
    if (!near) {
        return false;
    }
    Sums at = at_right_edge(part);
    if (part == 0) { // T and P are real at an edge of the contact
        at.D = Box(at.D.real());
    } else if (part == 1 && field_.untilted) {
        at.D = Box(Ball(0, bits), at.D.imaginary());
    }
    // F - F(e) = deviator (|D|^2 - |D_e|^2) + 2 by_mean (S - S_e) + mean (S - S_e)^2
    const Ball by_mean = mean_ * at.S;
    // The parts that are analytic at the edge, by their derivative over the half disc.
    Box others_G(bits);
    Box others_T(bits);
    for (std::size_t i = 0; i < field_.parts.size(); ++i) {
        if (i != part) {
            const LoadPart& other = field_.parts[i];
            const Box around(own.contact->a() + Ball::hull(-radius, radius), from_zero_to(radius));
            const Box rate = other.contact->cauchy_derivatives(around)[1];
            others_G = others_G + rate * weights_[i];
            others_T = others_T + rate * other.shear;
        }
    }
    const Box minus_i(Ball(0, bits), Ball(-1, bits));
    const Ball rho = Ball::hull(Ball(0, bits), sqrt(radius));
    const auto less_in = [&](const Ball& c, const Ball& s) { // cos(phi), sin(phi)
        const Box unit(c, s);
        const Box turn = unit * unit;
        const Box root = unit * rho;
        const Ball depth = c * s * 2; // z/rho^2
        // D = D_e + rho a + rho^2 b and S = S_e + rho a_S + rho^2 b_S
        const Box a = (unit * t - weights_[part] * conj(unit) * (depth / 2)) * near->root;
        const Box slope = near->rate + root * near->cubic;
        const Box own_G = near->rate + root * near->cubic * Ball(Rational(3, 2), bits) +
                          root * root * root * near->cubic_rate;
        const Box b = (own_G * weights_[part] + others_G) * depth - turn * (slope * t + others_T);
        const Box a_S = unit * weights_[part] * minus_i * (-near->root);
        const Box b_S = turn * (slope * weights_[part] + others_G) * minus_i;
        if (on_surface_only()) {
            const Ball A = a.real() + a_S.real();
            const Ball B = b.real() + b_S.real();
            return (arb_is_nonpositive(A.data()) != 0 && certainly_negative(B)) ||
                   certainly_negative(A + rho * B);
        }
        const Box by_rho = a + b * rho;
        const Ball S_by_rho = a_S.real() + b_S.real() * rho;
        const Ball B = (deviator_ * dot(at.D, b) + by_mean * b_S.real()) * 2 +
                       deviator_ * square_of_size(by_rho) + mean_ * square(S_by_rho);
        // A = 2 root (X cos phi + Y sin phi)
        const Ball X = deviator_ * at.D.real() * (t * (1 + s * s) - p * c * s) + by_mean * t;
        const Ball Y = deviator_ * at.D.imaginary() * (t * (1 + c * c) + p * c * s) - by_mean * p;
        const bool falls = arb_is_nonpositive(X.data()) != 0 && arb_is_nonpositive(Y.data()) != 0;
        return (falls && certainly_negative(B)) ||
               certainly_negative(near->root * (X * c + Y * s) * 2 + rho * B);
    };
    if (on_surface_only()) { // outside the part, and inside
        const Ball zero(0, bits);
        const Ball one(1, bits);
        return less_in(one, zero) && less_in(zero, one);
    }
    // Sectors, in parts of a right angle, are divided where they do not decide.
    constexpr double narrowest = 0x1p-14;
    std::vector<std::array<double, 2>> sectors{{0, 1}};
    while (!sectors.empty()) {
        const auto [from, width] = sectors.back();
        sectors.pop_back();
        const Ball turned = Ball::hull(Ball(Real(from), bits), Ball(Real(from + width), bits));
        const Ball phi = Ball::pi(bits) / 2 * turned;
        if (width <= 1.0 / 16 && less_in(cos(phi), sin(phi))) {
            continue;
        }
        if (width <= narrowest) {
            return false;
        }
        sectors.push_back({from + width / 2, width / 2});
        sectors.push_back({from, width / 2});
    }
    return true;
}

} // namespace edgeproof::contact
