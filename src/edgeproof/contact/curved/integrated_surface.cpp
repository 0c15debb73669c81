// SPDX-License-Identifier: BSD-3-Clause
// The gap beside a contact of a curved slope, and the potential of its pressure along the surface
// (docs/stress.md, "The displacements").
#include "edgeproof/contact/curved/integrated_contact.hpp"
#include "edgeproof/contact/enclosure/ball_values.hpp"
#include "edgeproof/contact/enclosure/fields.hpp"
#include "edgeproof/contact/enclosure/rigorous_integral.hpp"

#include <algorithm>
#include <optional>

namespace edgeproof::contact {
namespace {

/// The principal logarithm (DLMF 4.2.2); not finite where the box may meet the cut.
Box principal_log(const Box& x) {
    if (!certainly_positive(x.real()) && x.may_be_real()) {
        return unknown_box(x.bits());
    }
    Box r(x.bits());
    acb_log(r.get(), x.get(), r.bits());
    return r;
}

/// cos(theta), sin(theta) and theta of a place of a span.
struct Turned {
    Box cosine;
    Box sine;
    Box theta;
};
Turned turned_at(const SlopeOnSpan& on, const Box& t, const Box& s) {
    const long bits = t.bits();
    if (on.span.root == 0) {
        Turned at{Box(bits), Box(bits), t};
        acb_sin_cos(at.sine.get(), at.cosine.get(), t.get(), bits);
        return at;
    }
    const Box cosine = (s - on.centre) / on.half_length;
    const Box one(Ball(1, bits));
    const Box half = principal_root((one - cosine) / (cosine + 1)); // tan(theta/2)
    return {cosine, (cosine + 1) * half, principal_arctangent(half) * Ball(2, bits)};
}

} // namespace

Ball IntegratedContact::rise(const Ball& lo, const Ball& hi) const {
    Ball sum(0, bits_);
    for (std::size_t i = 0; i < profile_.pieces().size(); ++i) {
        const Ball from = i > 0 ? max(lo, slope_.knots[i - 1]) : lo;
        const Ball to = i < slope_.knots.size() ? min(hi, slope_.knots[i]) : hi;
        if (certainly_less(from, to)) {
            const Expr& slope = profile_.pieces()[i].slope;
            sum += integral_between([&](const Box& s) { return slope_over(slope, s); }, from, to,
                                    bits_, bits_)
                       .real();
        } else if (!certainly_less(to, from) && !(to - from).is_exact()) {
            sum += up_to(abs(to - from) * abs(series_of_slope(i, Ball::hull(from, to), 1)[0]));
        }
    }
    return sum;
}

// With omega and L = -ln omega as for linear slopes, and k the kernel of a unit jump of g':
// the integral of T from a is P L - (E* D/4) times that of (g' - mean) (pi - theta - k) sin(theta).
Ball IntegratedContact::lift_beyond(const Ball& beyond) const {
    const Ball half = length() / 2;
    const Ball W = Field<Ball>::root(beyond * (length() + beyond));
    const Ball omega = half / (half + beyond + W);
    const Ball pi = Ball::pi(bits_);
    const Ball mean = field_data().mean;
    const Box sum = over_spans(a_, b_, [&](const SlopeOnSpan& on, const Box& t, const Box& s) {
        const auto [cosine, sine, theta] = turned_at(on, t, s);
        const Box below = Box(Ball(1, bits_)) - cosine * omega;
        const Box above = times_i(sine * omega);
        // -i ln((1 - omega e^(-i theta))/(1 - omega e^(i theta)))
        const Box k = -times_i(principal_log(below + above) - principal_log(below - above));
        return (on.value(t, s) - mean) * (pi - theta - k) * sine;
    });
    return force() * log1p((beyond + W) / half) - modulus_ * half / 2 * sum.real();
}

Ball IntegratedContact::gap_beyond(Edge edge, const Ball& beyond) const {
    if (beyond.is_exact() && contains_zero(beyond)) {
        return beyond;
    }
    if (edge == Edge::left) {
        return mirrored().gap_beyond(Edge::right, beyond);
    }
    const Ball risen = rise(a_, a_ + beyond) - field_data().mean * beyond;
    if (certainly_less(beyond, length() * power_of_two(-bits_ / 4, bits_))) {
        // next to the edge the integral of the lift takes long; the lift is not negative
        return Ball::hull(Ball(0, bits_), upper_end(risen));
    }
    return risen - lift_beyond(beyond) * 2 / (Ball::pi(bits_) * modulus_);
}

// The force is (1/pi) Im of the integral of T from a, in which the Green function
// G = ln(2 d sin^2((phi + theta)/2)/|s - x|) has a logarithm at x, theta = phi. The spans that end
// there are integrated over y, with the distance from x proportional to exp(-y).
Ball IntegratedContact::carried_inside(const Ball& x,
                                       const std::optional<std::size_t>& knot) const {
    const Ball half = length() / 2;
    const Ball place = knot ? slope_.knots[*knot] : x;
    const Ball phi = clamped_mark({a_, b_}, place).h;
    const Ball mean = field_data().mean;
    const Box one(Ball(1, bits_));
    const auto sum_of_angles = [&](const Box& theta) { // sin((phi + theta)/2)
        return cos(Box(Ball::pi(bits_) / 2) - (theta + phi) / Ball(2, bits_));
    };
    const auto weight = [&](const SlopeOnSpan& on, const Box& t, const Box& s, const Box& sine) {
        return (on.value(t, s) - mean) * sine;
    };
    Ball sum(0, bits_);
    for (const quadrature::ThetaSpan& span : spans(a_, b_, phi)) {
        const SlopeOnSpan on{profile_.pieces()[span.piece].slope, roots().formulas[span.formula],
                             span, (a_ - b_) / 2, half};
        const bool at_right = span.root == 0 && overlaps(span.from, phi);
        const bool at_left = span.root == 0 && overlaps(span.to, phi);
        const bool at_root = span.root != 0 && knot && overlaps(span.knot, place);
        if (!at_right && !at_left && !at_root) {
            sum += on.integral(
                         [&](const SlopeOnSpan& here, const Box& t, const Box& s) {
                             const auto [cosine, sine, theta] = turned_at(here, t, s);
                             const Box root = sum_of_angles(theta);
                             const Box apart =
                                 certainly_less(x, middle(s.real())) ? s - place : place - s;
                             return weight(here, t, s, sine) *
                                    principal_log(root * root * (half * 2) / apart);
                         },
                         bits_, bits_)
                       .real();
            continue;
        }
        const Ball size = at_root ? span.to : span.to - span.from;
        const long n = std::max(span.root, 1L);
        const Ball Y = middle(log(Ball(2, bits_)) * (bits_ + 16) / n);
        const auto over_y = [&](const Box& part) {
            const Box y = part * Y;
            Box distance(bits_);
            acb_exp(distance.get(), (-y).get(), bits_);
            distance = distance * size;
            const Box t = at_root ? distance : at_right ? distance + phi : phi - distance;
            Box s(bits_);
            Box rate(bits_);
            span.map(s.get(), rate.get(), t.get(), on.centre, half, bits_);
            const auto [cosine, sine, theta] = turned_at(on, t, s);
            const Box root = sum_of_angles(theta);
            Box G(bits_); // without n y
            if (at_root) {
                G = principal_log(root * root * (half * 2)) - log(size) * n;
            } else { // |s - x| = 2 d sin((phi + theta)/2) sin(distance/2)
                Box sinc(bits_);
                acb_sinc(sinc.get(), (distance / Ball(2, bits_)).get(), bits_);
                G = principal_log(root) - principal_log(sinc) - log(size / 2);
            }
            return weight(on, t, s, sine) * (G + y * Ball(n, bits_)) * rate * distance;
        };
        sum += Y * integral_of(over_y, {bits_, bits_, Ball(0, bits_), Ball(1, bits_)});
        // The rest, |s - x| <= e: |g' - mean| is at most the whole rise of g', and G at most
        // ln(2 d/|s - x|).
        const Ball e = upper_end((at_root ? pow_int(size, n) : size * half) * exp(-Y * n));
        const Ball most = over_theta().most_change.ball(bits_);
        sum += up_to(most / half * e * (log(length() / e) + 1));
    }
    return phi / Ball::pi(bits_) * force() - modulus_ * half / (Ball::pi(bits_) * 2) * sum;
}

SurfacePotential IntegratedContact::surface_potential(const Ball& x,
                                                      const std::optional<Exact>& known) const {
    const Ball zero(0, bits_);
    const Ball factor = Ball::pi(bits_) * modulus_ / 2;
    const Ball right = x - a_;
    const Ball left = -x - b_;
    const auto lift_inside = [&](const Ball& to) {
        return -factor * (rise(to, a_) - field_data().mean * (a_ - to));
    };
    if (certainly_positive(right)) {
        return {lift_beyond(right), zero};
    }
    if (certainly_positive(left)) {
        return {lift_inside(-b_) + mirrored().lift_beyond(left), force()};
    }
    for (const Edge edge : {Edge::right, Edge::left}) {
        const Ball& off = edge == Edge::right ? right : left;
        const Ball lift = edge == Edge::right ? zero : lift_inside(-b_);
        const Ball there = edge == Edge::right ? zero : force();
        if (contains_zero(off) && off.is_exact()) {
            return {lift, there};
        }
        if (contains_zero(off)) {
            const Ball slack = upper_end(abs(off));
            const Box T = cauchy_integral(Box(x)).value;
            return {lift + up_to(abs(T.real()) * slack),
                    there + up_to(abs(T.imaginary()) * slack / Ball::pi(bits_))};
        }
    }
    const auto knot = knot_at(known);
    if (!knot && !piece_of(x)) {
        return {unknown_ball(bits_), unknown_ball(bits_)};
    }
    return {lift_inside(knot ? slope_.knots[*knot] : x), carried_inside(x, knot)};
}

} // namespace edgeproof::contact
