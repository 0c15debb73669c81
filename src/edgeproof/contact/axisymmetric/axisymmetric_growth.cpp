// SPDX-License-Identifier: BSD-3-Clause
// The approach of an axisymmetric contact as a function of its radius, and what follows from it at
// the edge.
#include "edgeproof/contact/axisymmetric/axisymmetric_contact.hpp"
#include "edgeproof/contact/enclosure/ball_values.hpp"
#include "edgeproof/contact/enclosure/fields.hpp"
#include "edgeproof/contact/enclosure/rigorous_integral.hpp"
#include "edgeproof/contact/law/edge_expansion.hpp"
#include "edgeproof/contact/profile/slope.hpp"

#include <functional>
#include <utility>
#include <vector>

namespace edgeproof::contact {
namespace {

constexpr long values_a_bit = 4; ///< of h', before its series are computed

} // namespace

AxisymmetricContact::Radius AxisymmetricContact::radius(const Ball& s) const {
    Radius at{Box(s), {}};
    for (const Ring& ring : rings_) {
        if (on_edge_[ring.knot] || certainly_less(s, ring.v)) {
            break;
        }
        at.y.emplace_back(Field<Ball>::root(clamped(s - ring.v) * (s + ring.v)));
    }
    return at;
}

AxisymmetricContact::Radius AxisymmetricContact::radius(const Box& A, std::optional<std::size_t> on,
                                                        const Box& w) const {
    const Box w2 = w * w;
    Radius at{on && on_axis(*on) ? w : principal_root(w2 + A * A), {}};
    for (std::size_t i = 0; i < rings_.size(); ++i) {
        const Ball& v = rings_[i].v;
        if (on == i) {
            at.y.push_back(w);
            break;
        }
        if (!on && !certainly_less(v, A.real())) { // the knots before ring `on` lie before A
            break;
        }
        at.y.push_back(principal_root(w2 + (A - v) * (A + v)));
    }
    return at;
}

AxisymmetricContact::Radius AxisymmetricContact::radius_beyond(const Box& A, std::size_t end,
                                                               const Box& w2) const {
    Radius at{principal_root(w2 + A * A), {}};
    for (std::size_t i = 0; i < end; ++i) {
        at.y.push_back(principal_root(w2 + (A - rings_[i].v) * (A + rings_[i].v)));
    }
    return at;
}

AxisymmetricContact::Radius AxisymmetricContact::radius_near_edge(const Box& z) const {
    Radius at{z + a_, {}};
    for (const Ring& ring : rings_) {
        if (!inside(ring.knot)) {
            break;
        }
        at.y.push_back(principal_root((z + (a_ - ring.v)) * (z + (a_ + ring.v))));
    }
    return at;
}

Box AxisymmetricContact::value(std::size_t knot, const Box& r, Integrand of) const {
    const std::vector<Box> g = holomorphic_series(profile_.pieces()[knot + 1].slope, r,
                                                  of == Integrand::rate ? 2 : 1, bits_);
    return of == Integrand::slope          ? g[0]
           : of == Integrand::first_moment ? g[0] * r
           : of == Integrand::moment       ? g[0] * r * r
                                           : g[0] + g[1] * r;
}

Box AxisymmetricContact::rate_over_radius(const Box& r) const {
    if (!r.contains_zero()) {
        return value(rings_[0].knot, r, Integrand::rate) / r;
    }
    // A mean of the derivative, 2 g'' + r g''', over the way from the axis.
    const Box all = Box::hull(r, Box(Ball(0, bits_)));
    const std::vector<Box> g =
        holomorphic_series(profile_.pieces()[rings_[0].knot + 1].slope, all, 3, bits_);
    return (g[1] + g[2] * all) * Ball(2, bits_);
}

// docs/axisymmetric.md, "Curved slopes": r = s cos(psi)
Box AxisymmetricContact::over_rings(const Radius& at, Integrand of) const {
    Box sum(bits_);
    if (linear_) { // docs/axisymmetric.md, "Piecewise linear slopes"
        for (std::size_t i = 0; i < at.y.size(); ++i) {
            const auto& [v, jump, rate, knot] = rings_[i];
            const Box& y = at.y[i];
            const Box A = angle(at, i);
            if (of == Integrand::slope) {
                sum = sum + A * jump + (y - A * v) * rate;
            } else {
                const Box s2A = at.s * at.s * A;
                sum = sum + ((s2A + y * v) * jump +
                             (y * y * y * (Ball(4, bits_) / 3) - (s2A - y * v) * v) * rate) /
                                Ball(2, bits_);
            }
        }
        return sum;
    }
    const bool narrow = is_narrow(at.s);
    Box outer(Ball::pi(bits_) / 2);
    for (std::size_t i = 0; i < at.y.size(); ++i) {
        const bool last = i + 1 == at.y.size();
        const Box inner = last ? Box(bits_) : principal_arctangent(at.y[i + 1] / rings_[i + 1].v);
        const Box width = outer - inner;
        sum = sum + width * integral_or_range(
                                [&](const Box& t) {
                                    return value(rings_[i].knot, at.s * cos(inner + width * t), of);
                                },
                                narrow, bits_);
        outer = inner;
    }
    return sum;
}

Box AxisymmetricContact::by_series(std::size_t function, const Box& variable,
                                   const TaylorCover::Function& f) const {
    // As many values as the series cost are computed directly first.
    if (rates_->values > values_a_bit * bits_) {
        const std::vector<Box> found =
            rates_->of_function[function].at(f, variable, 1, a_ * 2 + rings_.back().v);
        if (!found.empty()) {
            return found[0];
        }
    }
    rates_->values += is_narrow(variable) ? 1 : 0;
    return f(variable);
}

Box AxisymmetricContact::rate_over_radius_at(const Box& radius) const {
    return by_series(rings_.size(), radius, [&](const Box& s) {
        const Ball quarter = Ball::pi(bits_) / 2;
        return integral_or_range(
                   [&](const Box& t) {
                       const Box part = cos(t * quarter); // r/s
                       return rate_over_radius(s * part) * part;
                   },
                   is_narrow(s), bits_) *
               quarter;
    });
}

Box AxisymmetricContact::angle(const Radius& at, std::size_t ring) const {
    return on_axis(ring) ? Box(Ball::pi(bits_) / 2)
                         : principal_arctangent(at.y[ring] / rings_[ring].v);
}

Box AxisymmetricContact::smooth_rate(const Radius& at) const {
    Box sum = linear_ ? Box(bits_) : over_rings(at, Integrand::rate);
    for (std::size_t i = 0; i < at.y.size(); ++i) {
        const auto& [v, jump, rate, knot] = rings_[i];
        const bool corner = !contains_zero(jump);
        if (linear_) {
            const Box A = angle(at, i);
            sum = sum + (at.y[i] * Ball(2, bits_) - A * v) * rate;
            sum = corner ? sum + A * jump : sum;
        }
        if (corner && i + 1 < at.y.size() && !on_axis(i)) {
            sum = sum + Box(jump * v) / at.y[i];
        }
    }
    return sum;
}

Box AxisymmetricContact::approach_rate(const Radius& at, std::optional<std::size_t> except) const {
    if (at.y.empty()) {
        return Box(bits_);
    }
    const std::size_t last = at.y.size() - 1;
    const Ball& v = rings_[last].v;
    const Ball& jump = rings_[last].jump;
    const Box& y = at.y[last];
    const Box sum = linear_ ? smooth_rate(at) : by_series(last, y, [&](const Box& w) {
        return smooth_rate(&w == &y ? at : radius(Box(v), last, w));
    });
    return contains_zero(jump) || last == except || on_axis(last) ? sum : sum + Box(jump * v) / y;
}

Ball AxisymmetricContact::approach_rate_at(const Ball& s) const {
    const Radius at = radius(s);
    // The series beyond a ring that s may lie on does not hold before it.
    const bool on_ring = !at.y.empty() && at.y.back().contains_zero();
    return (on_ring && contains_zero(rings_[at.y.size() - 1].jump) ? smooth_rate(at)
                                                                   : approach_rate(at, {}))
        .real();
}

Ball AxisymmetricContact::approach_at(const Ball& s) const {
    return s * over_rings(radius(s), Integrand::slope).real();
}

Ball AxisymmetricContact::force_at(const Ball& s) const {
    return modulus_ * 2 * over_rings(radius(s), Integrand::moment).real();
}

std::vector<Ball> AxisymmetricContact::expansion(Edge /*edge*/, std::size_t terms) const {
    if (terms == 0) {
        return {};
    }
    std::vector<Ball> rates = approach_rates(terms);
    for (Ball& rate : rates) {
        rate *= modulus_;
    }
    // The plane contact with P'(s) = E* h'(s) has the same pressure.
    const LawSeries<BallSeries> law{BallSeries(rates), BallSeries::variable(a_, terms)};
    return coefficients_of(right_edge_brackets(law, a_), Ball(a_ * 2));
}

// p/sqrt(u) = (E*/pi) times the integral of h'(a - u t) (1 - t)^(-1/2) (2a - u (1 + t))^(-1/2) over
// 0 < t < 1 (docs/axisymmetric.md, "The expansion").
Ball AxisymmetricContact::most_rate(const Ball& rho) const {
    return greatest_on_disk(
        [&](const Box& s) { return approach_rate(radius_near_edge(s - a_), {}); }, a_, rho);
}

Ball AxisymmetricContact::reach(Edge /*edge*/) const {
    Ball rho = a_;
    for (const Ring& ring : rings_) {
        if (inside(ring.knot)) {
            rho = min(rho, a_ - ring.v);
        }
    }
    if (linear_) {
        return rho;
    }
    rho = lower_end(rho) * 3 / 4;
    for (int k = 0; k < 40 && certainly_positive(rho); ++k, rho = rho / 2) {
        if (most_rate(rho).is_finite()) {
            return lower_end(rho);
        }
    }
    return {0, bits_};
}

// Of a linear slope |h'| is bounded over the disk |s - a| <= rho in closed form. There v < |s|, so
// that the angle A = arccos(v/s) has |A| <= pi/2 + arcsin(v/|s|) <= pi (the series of arcsin has no
// negative coefficient), and y^2 = (s - v) (s + v).
Ball AxisymmetricContact::majorant(Edge /*edge*/, const Ball& rho) const {
    const Ball pi = Ball::pi(bits_);
    const Ball least = a_ - rho;
    const Ball greatest = a_ + rho;
    Ball most = linear_ ? Ball(0, bits_) : most_rate(rho);
    for (const Ring& bend : linear_ ? rings_ : std::vector<Ring>{}) {
        const Ball& v = bend.v;
        if (arb_is_zero(v.data()) != 0) {
            most += abs(bend.jump) * pi / 2 + abs(bend.rate) * greatest * 2;
        } else if (inside(bend.knot)) {
            most += abs(bend.rate) * (sqrt((greatest - v) * (greatest + v)) * 2 + v * pi);
            if (!contains_zero(bend.jump)) {
                most += abs(bend.jump) * (pi + v / sqrt((least - v) * (least + v)));
            }
        }
    }
    return modulus_ / pi * most * 2 / sqrt(least * 2);
}

BallSeries AxisymmetricContact::linear_approach_rates(std::size_t terms) const {
    const BallSeries s = BallSeries::variable(a_, terms);
    BallSeries rate(Ball(0, bits_), terms);
    for (const Ring& bend : rings_) {
        if (arb_is_zero(bend.v.data()) != 0) {
            rate = rate + s * (bend.rate * 2) + bend.jump * Ball::pi(bits_) / 2;
        } else if (!on_edge_[bend.knot] && !certainly_less(a_, bend.v)) {
            if (!certainly_less(bend.v, a_)) {
                return unknown_series(terms, bits_);
            }
            BallSeries y2 = s * s + -(bend.v * bend.v);
            y2.set(0, (a_ - bend.v) * (a_ + bend.v));
            const BallSeries y = sqrt(y2);
            const BallSeries A = atan(y * (1 / bend.v));
            rate = rate + (y * Ball(2, bits_) - A * bend.v) * bend.rate;
            if (!contains_zero(bend.jump)) {
                rate = rate + (A + BallSeries(bend.v, terms) / y) * bend.jump;
            }
        }
    }
    return rate;
}

// Of a curved slope on a circle of a sixteenth of the disk on which h' is bounded: each value is an
// integral.
std::vector<Ball> AxisymmetricContact::approach_rates(std::size_t terms) const {
    if (linear_) {
        return linear_approach_rates(terms).coefficients();
    }
    const Ball rho = reach(Edge::right);
    if (!certainly_positive(rho)) {
        return std::vector<Ball>(terms, unknown_ball(bits_));
    }
    return taylor_on_circle([&](const Box& z) { return approach_rate(radius_near_edge(z), {}); },
                            upper_end(most_rate(rho)), rho, Rational(1, 16), terms);
}

std::vector<Ball> AxisymmetricContact::force_rates(std::size_t terms) const {
    const std::vector<Ball> h = approach_rates(terms);
    std::vector<Ball> rates;
    for (std::size_t k = 0; k < terms; ++k) {
        const Ball rate = (k == 0 ? h[k] * a_ : h[k] * a_ + h[k - 1]) * modulus_ * 2;
        rates.push_back(k % 2 == 0 ? rate : -rate);
    }
    return rates;
}

} // namespace edgeproof::contact
