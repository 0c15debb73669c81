// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/contact/axisymmetric/axisymmetric_contact.hpp"

#include "edgeproof/contact/enclosure/ball_values.hpp"
#include "edgeproof/contact/enclosure/fields.hpp"
#include "edgeproof/contact/enclosure/isolate_zero.hpp"
#include "edgeproof/contact/enclosure/rigorous_integral.hpp"
#include "edgeproof/contact/law/edge_expansion.hpp"
#include "edgeproof/contact/profile/slope.hpp"

#include <algorithm>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace edgeproof::contact {
namespace {

constexpr const char* radius_sought = "the radius of the contact";

class AxisymmetricZones : public ZoneSolver {
public:
    explicit AxisymmetricZones(const AxisymmetricContact& contact)
        : ZoneSolver(contact), contact_(contact) {}
    [[nodiscard]] ZoneValues values(const BallZone& zone) const override {
        return {contact_.with_radius(zone.a).force(), Ball(0, bits())};
    }
    [[nodiscard]] ZoneRates rates(const BallZone& zone) const override {
        const Ball rate = contact_.with_radius(zone.a).force_rate();
        return {rate, rate};
    }
    [[nodiscard]] Ball pressure(const BallZone& zone, Edge edge, const Ball& u,
                                const std::optional<Exact>& x) const override {
        const AxisymmetricContact part = contact_.with_radius(zone.a);
        return x ? part.pressure(edge, u, *x) : part.pressure(edge, u);
    }
    [[nodiscard]] BallZone zone(const Ball& force, const Ball& /*tilt*/,
                                const BallZone& near) const override {
        const Ball a = contact_.radius_for(force, near.a);
        return {a, a};
    }
    [[nodiscard]] std::vector<Ball> force_rates(const Ball& a, std::size_t terms) const override {
        return contact_.with_radius(a).force_rates(terms);
    }
    [[nodiscard]] BallZone core() const override {
        return {contact_.minimum_end(), contact_.minimum_end()};
    }
    [[nodiscard]] std::size_t cost() const override { return contact_.cost(); }

private:
    AxisymmetricContact contact_;
};

} // namespace

std::optional<Exact> AxisymmetricContact::not_analytic_at(const Profile& profile) {
    constexpr long bits = 128;
    const auto finite = [&](std::size_t piece, const Ball& v) {
        const Ball apart = up_to(power_of_two(-100, bits));
        return holomorphic_series(profile.pieces()[piece].slope, Box(v + apart, apart), 2, bits)[1]
            .is_finite();
    };
    for (std::size_t i = profile.origin(); i < profile.knots().size(); ++i) {
        const Ball v = formula::ball_of(profile.knots()[i], bits);
        if (!finite(i + 1, v) || (i > profile.origin() && !finite(i, v))) {
            return profile.knots()[i];
        }
    }
    return {};
}

AxisymmetricContact::AxisymmetricContact(const Profile& profile, const Exact& contact_modulus,
                                         const Load& load, long bits)
    : ProvedContact(profile, enclosed_constant(contact_modulus, bits), bits),
      linear_(profile.piecewise_linear()) {
    for (std::size_t i = slope_.origin; i < slope_.knots.size(); ++i) {
        const bool first = i == slope_.origin;
        const Ball& v = slope_.knots[i];
        Ball jump(0, bits);
        Ball rate(0, bits);
        if (linear_) {
            jump = first ? slope_.pieces[i + 1].at_origin : slope_.jump(i);
            rate = first ? slope_.rate(i + 1) : -slope_.rate_drop(i);
            if (Field<Ball>::vanishes(jump) && Field<Ball>::vanishes(rate)) {
                continue; // a flat begins at the origin without a bend
            }
        } else if (profile.has_corner(i)) {
            jump = value(i, Box(v), Integrand::slope).real();
            if (!first) {
                jump -= value(i - 1, Box(v), Integrand::slope).real();
            }
        }
        rings_.push_back({v, std::move(jump), std::move(rate), i});
    }
    rates_ = std::make_shared<Rates>();
    rates_->of_function.assign(rings_.size() + 1, TaylorCover(bits));
    pressures_ = std::make_shared<TaylorCover>(bits);
    find_radius(load);
}

void AxisymmetricContact::find_radius(const Load& load) {
    const Ball given = enclosed_constant(load.value, bits_);
    if (load.kind == Load::Kind::right_edge) {
        known_a_ = load.value;
        a_ = given;
        find_knots_on_edges();
    } else if (load.kind == Load::Kind::force) {
        a_ = radius_for(given, Ball(1, bits_));
    } else {
        a_ = isolate_zero([&](const Ball& s) { return given - approach_at(s); },
                          [&](const Ball& s) { return -approach_rate_at(s); }, Ball(1, bits_),
                          radius_sought);
    }
    b_ = a_;
}

Ball AxisymmetricContact::radius_for(const Ball& P, const Ball& start) const {
    return isolate_zero([&](const Ball& s) { return P - force_at(s); },
                        [&](const Ball& s) { return -(modulus_ * s * approach_rate_at(s) * 2); },
                        start, radius_sought);
}

AxisymmetricContact AxisymmetricContact::with_radius(const Ball& a) const {
    AxisymmetricContact c(*this);
    c.move_edges(a, a);
    c.pressures_ = std::make_shared<TaylorCover>(bits_);
    return c;
}

bool AxisymmetricContact::inside(std::size_t knot) const {
    return !on_edge_[knot] && !certainly_less(a_, abs(slope_.knots[knot]));
}

bool AxisymmetricContact::begins_flat(const Ring& ring) const {
    const SlopePiece& piece = profile_.pieces()[ring.knot + 1];
    return piece.linear && certainly_zero(piece.linear->rate) && !profile_.has_corner(ring.knot);
}

bool AxisymmetricContact::is_flat_before(std::size_t ring) const {
    return std::all_of(rings_.begin(), rings_.begin() + static_cast<std::ptrdiff_t>(ring),
                       [&](const Ring& before) { return begins_flat(before); });
}

Ball AxisymmetricContact::minimum_end() const {
    const auto rises = std::find_if(rings_.begin(), rings_.end(),
                                    [&](const Ring& ring) { return !begins_flat(ring); });
    return rises == rings_.end() ? Ball(0, bits_) : rises->v;
}

std::unique_ptr<ZoneSolver> axisymmetric_zones(const AxisymmetricContact& contact) {
    return std::make_unique<AxisymmetricZones>(contact);
}

// Integrals over the approach: the gap outside the contact, and the energy of a cycle.

// docs/axisymmetric.md, "The gap", with s = r cos(psi)
Ball axisymmetric_gap(const BallContact& plane, const Ball& beyond) {
    const long bits = plane.bits();
    const Ball& a = plane.a();
    const Ball r = a + beyond;
    const Ball rate = plane.force_rate() / plane.modulus(); // h'(a)
    const std::optional<PowerLaw<Ball>>& power = plane.power_law();
    const Box exponent(power ? power->exponent : Ball(plane.slope().has_corner(0) ? 0 : 1, bits));
    const Ball angle = atan2(sqrt(beyond * (a + r)), a); // psi of the edge
    const auto integrand = [&](const Box& t) {
        const Box psi = t * angle;
        Box sine(bits);
        Box cosine(bits);
        acb_sin_cos(sine.get(), cosine.get(), psi.get(), bits);
        if (!certainly_positive(cosine.real())) {
            return unknown_box(bits); // near a cut
        }
        Box grown(bits);
        acb_pow(grown.get(), (cosine * r / a).get(), exponent.get(), bits);
        return psi * sine * grown;
    };
    const IntegralGoal goal{bits, useful_accuracy(beyond.relative_accuracy_bits(), bits),
                            Ball(0, bits), Ball(1, bits)};
    return integral_of(integrand, goal) * rate * angle * r * 2 / Ball::pi(bits);
}

// With s = a exp(-x) the power is an exponential. Beyond x = X the integrand is bounded by its
// values in the box of the remaining s.
Ball over_approach(const BallContact& plane, const std::function<Box(const Box& s)>& f) {
    const long bits = plane.bits();
    const std::optional<PowerLaw<Ball>>& law = plane.power_law();
    const Ball power =
        law ? law->exponent + 1 : Ball(plane.slope().has_corner(0) ? 1 : 2, bits); // m + 1
    const Ball& a = plane.a();
    const Ball scale = plane.force_rate() / plane.modulus() * a; // a h'(a)
    const Ball X = middle(log(Ball(2, bits)) * (bits + 16) / power);
    const auto place = [&](const Box& x) {
        Box s(bits);
        acb_exp(s.get(), (-x).get(), bits);
        return s * a;
    };
    const Ball whole = X * integral_of(
                               [&](const Box& t) {
                                   const Box x = t * X;
                                   Box weight(bits);
                                   acb_exp(weight.get(), (x * -power).get(), bits);
                                   return f(place(x)) * weight;
                               },
                               {bits, bits, Ball(0, bits), Ball(1, bits)});
    const Ball rest = place(Box(X)).real();
    const Ball end = upper_end(exp(-power * X)) / power;
    return scale * (whole + up_to(end * upper_end(abs(f(Box(Ball::hull(Ball(0, bits), rest)))))));
}

// With w = sqrt(s^2 - A^2) = D cos(psi) between two knots, D^2 = to^2 - A^2, both roots are
// analytic.
Ball AxisymmetricContact::over_approach(
    const Ball& from, std::optional<std::size_t> on, const Ball& beyond,
    const std::function<Box(const Radius& at, const Box& depth)>& f, const Ball& scale,
    long known) const {
    const Ball to = from + beyond;
    const Ball quarter = Ball::pi(bits_) / 2;
    const IntegralGoal goal{
        bits_, useful_accuracy(std::min(known, beyond.relative_accuracy_bits()), bits_), scale,
        Ball(1, bits_)};
    Ball sum(0, bits_);
    Ball A = from;
    Ball left = beyond; // to - A
    for (std::size_t i = on ? *on + 1 : 0;; ++i) {
        const bool last = i == rings_.size() || !certainly_less(rings_[i].v, to);
        if (!last && !certainly_less(A, rings_[i].v)) {
            if (certainly_less(rings_[i].v, A)) {
                continue;
            }
            return unknown_ball(bits_);
        }
        if (is_flat_before(i)) { // the integral of an enclosure of 0 would not end
            if (last) {
                return sum;
            }
            A = rings_[i].v;
            left = to - A;
            on = i;
            continue;
        }
        const Ball D = Field<Ball>::root(left * (to + A));
        const Ball first = last ? Ball(0, bits_)
                                : atan2(sqrt((to - rings_[i].v) * (to + rings_[i].v)),
                                        sqrt((rings_[i].v - A) * (rings_[i].v + A)));
        const Ball width = quarter - first;
        sum += width * integral_of(
                           [&](const Box& t) {
                               const Box psi = t * width + first;
                               const Box w = cos(psi) * D;
                               const Box depth = cos(Box(quarter) - psi) * D;
                               const Radius at = radius(Box(A), on, w);
                               Box rate = approach_rate(at, on); // ds/dw
                               if (!on || !on_axis(*on)) {
                                   rate = rate * w;
                                   rate =
                                       (on ? rate + rings_[*on].jump * rings_[*on].v : rate) / at.s;
                               }
                               return f(at, depth) * rate * depth;
                           },
                           goal);
        if (last) {
            return sum;
        }
        A = rings_[i].v;
        left = to - A;
        on = i;
    }
}

// Of a linear slope ring by ring, since one arctangent at a time is faster than a sum of all, with
// s^2 = v^2 + y^2 and ds = y dy/s.
Ball AxisymmetricContact::over_approach(const std::function<Box(const Box& s, const Box& s2)>& f,
                                        const std::function<Ball(long power)>& of_power,
                                        long known) const {
    if (!linear_) {
        return over_approach(
            Ball(0, bits_), on_axis(0) ? std::optional<std::size_t>(0) : std::nullopt, a_,
            [&](const Radius& at, const Box& /*depth*/) { return f(at.s, at.s * at.s); },
            Ball(0, bits_), known);
    }
    Ball sum(0, bits_);
    for (std::size_t i = 0; i < rings_.size() && (on_axis(i) || inside(rings_[i].knot)); ++i) {
        const Ball& v = rings_[i].v;
        const Ball& jump = rings_[i].jump;
        const Ball& rate = rings_[i].rate;
        const Ball quarter = Ball::pi(bits_) / 2;
        if (on_axis(i) && of_power) {
            sum += of_power(1) * rate * 2;
            sum += contains_zero(jump) ? Ball(0, bits_) : of_power(0) * jump * quarter;
            continue;
        }
        const Ball Y = on_axis(i) ? a_ : Field<Ball>::root(clamped(a_ - v) * (a_ + v));
        const long accuracy = useful_accuracy(std::min(known, Y.relative_accuracy_bits()), bits_);
        const auto integrand = [&](const Box& t) {
            const Box y = t * Y;
            const Box y2 = y * y;
            if (on_axis(i)) {
                return f(y, y2) * (y * (rate * 2) + jump * quarter);
            }
            const Box s2 = y2 + v * v;
            const Box s = principal_root(s2);
            const Box A = principal_arctangent(y / v);
            const Box slope = (A * y + v) * jump + (y * Ball(2, bits_) - A * v) * y * rate;
            return f(s, s2) * slope / s;
        };
        sum += Y * integral_of(integrand, {std::min(bits_, accuracy + 64), accuracy, Ball(0, bits_),
                                           Ball(1, bits_)});
    }
    return sum;
}

// docs/axisymmetric.md, "The gap"
Ball AxisymmetricContact::gap_beyond(const Ball& beyond) const {
    const Ball r = a_ + beyond;
    std::optional<std::size_t> on;
    Ball rest(0, bits_); // of rings that r may lie on
    for (std::size_t i = 0; i < rings_.size(); ++i) {
        const Ball& v = rings_[i].v;
        if (on_edge_[rings_[i].knot]) {
            on = i;
        } else if (!on_axis(i) && overlaps(v, r)) {
            // At most the greatest arccos times the part of the ring in h(r).
            const Box near(Ball::hull(v, r));
            const std::size_t knot = rings_[i].knot;
            const Ball bend = abs(value(knot, near, Integrand::slope).real() -
                                  value(knot - 1, near, Integrand::slope).real());
            const Ball A = atan2(Field<Ball>::root(clamped(r - v) * (r + v)), v);
            rest += up_to(upper_end(r * A * A * bend));
        }
    }
    const auto arc = [&](const Radius& /*at*/, const Box& depth) {
        Box x = depth / r;
        if (!certainly_less(abs(x), Ball(1, bits_))) {
            return unknown_box(bits_); // near a cut
        }
        acb_asin(x.get(), x.get(), bits_);
        return x;
    };
    return (over_approach(a_, on, beyond, arc, Ball(0, bits_)) + rest) * 2 / Ball::pi(bits_);
}

// docs/axisymmetric.md, "The energy of a cycle"
Ball AxisymmetricContact::loop_integral(const Ball& from, const Ball& tau) const {
    const Ball P = force();
    const Ball mean = P * (1 - tau / 2);
    const auto loop = [&](const Radius& at, const Box& /*depth*/) {
        return Box(mean) - over_rings(at, Integrand::moment) * (modulus_ * 2);
    };
    return over_approach(from, {}, a_ - from, loop, P * tau * (approach() - approach_at(from)));
}

// Between two knots L is analytic in w = sqrt(s^2 - v^2), where v is the knot before
// (docs/histories.md, "The energy"); ds/s = w dw/s^2.
Ball AxisymmetricContact::over_plane_widths(const Ball& from, const Ball& to,
                                            const std::function<Box(const Box& L)>& f) const {
    Ball sum(0, bits_);
    for (std::size_t i = 0; i < rings_.size(); ++i) {
        const Ball& v = rings_[i].v;
        const bool last = i + 1 == rings_.size();
        if (certainly_less(to, v) || (!last && certainly_less(rings_[i + 1].v, from))) {
            continue;
        }
        const Ball begin = max(from, v);
        const Ball end = last ? to : min(to, rings_[i + 1].v);
        const Ball first = Field<Ball>::root(clamped(begin - v) * (begin + v));
        const Ball final = Field<Ball>::root(clamped(end - v) * (end + v));
        const Ball both = first + final; // it may be 0 where an edge is on the knot
        const Ball width = certainly_positive(both) ? (end - begin) * (end + begin) / both : both;
        const IntegralGoal goal{bits_, useful_accuracy(width.relative_accuracy_bits(), bits_),
                                Ball(0, bits_), Ball(1, bits_)};
        sum += width * integral_of(
                           [&](const Box& t) {
                               const Box w = t * width + first;
                               const Radius at = radius(Box(v), i, w);
                               const Box L = over_rings(at, Integrand::first_moment);
                               return f(L * modulus_) * w / (at.s * at.s);
                           },
                           goal);
    }
    return sum;
}

} // namespace edgeproof::contact
