// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/axisymmetric/axisymmetric_contact.hpp"

#include "edgeproof/contact/enclosure/ball_marks.hpp"
#include "edgeproof/contact/enclosure/ball_values.hpp"
#include "edgeproof/contact/enclosure/isolate_zero.hpp"

#include <utility>

namespace edgeproof::contact {

AxisymmetricContact::AxisymmetricContact(const Profile& profile,
                                         const formula::Exact& contact_modulus, const Load& load,
                                         long bits)
    : RoundContact(profile, enclosed_constant(contact_modulus, bits), bits) {
    const std::size_t origin = slope_.origin;
    for (std::size_t i = origin; i < slope_.knots.size(); ++i) {
        const bool first = i == origin;
        Ball jump = first ? slope_.pieces[i + 1].at_origin : slope_.jump(i);
        Ball rate = first ? slope_.rate(i + 1) : -slope_.rate_drop(i);
        const bool none = arb_is_zero(jump.data()) != 0 && arb_is_zero(rate.data()) != 0;
        if (!none) { // a flat begins at the origin without a bend
            bends_.push_back({slope_.knots[i], std::move(jump), std::move(rate), first, i});
        }
    }
    const Ball given = enclosed_constant(load.value, bits);
    if (load.kind == Load::Kind::right_edge) {
        known_a_ = load.value;
        a_ = given;
        find_knots_on_edges();
    } else if (load.kind == Load::Kind::force) {
        a_ = radius_for(given);
    } else {
        const Ball start = max(bends_.back().v * 2, given);
        a_ = isolate_zero([&](const Ball& s) { return given - approach_at(s); },
                          [&](const Ball& s) { return -approach_rate(s); }, start,
                          "the radius of the contact", {});
    }
    b_ = a_;
}

Ball AxisymmetricContact::radius_for(const Ball& P) const {
    const Ball start = bends_.back().at_origin ? Ball(1, bits_) : bends_.back().v * 2;
    return isolate_zero([&](const Ball& s) { return P - force_at(s); },
                        [&](const Ball& s) { return -(modulus_ * s * approach_rate(s) * 2); },
                        start, "the radius of the contact", {});
}

AxisymmetricContact AxisymmetricContact::with_radius(const Ball& a) const {
    AxisymmetricContact c(*this);
    c.move_edges(a, a);
    return c;
}

/// The sum of f(bend, y, A) over the bends inside the radius s: y = sqrt(s^2 - v^2),
/// A = arccos(v/s).
template <class F> Ball AxisymmetricContact::over_bends(const Ball& s, const F& f) const {
    Ball sum(0, bits_);
    for (const Bend& bend : bends_) {
        if (bend.at_origin) {
            sum += f(bend, s, Ball::pi(bits_) / 2);
        } else if (on_edge_[bend.knot] != Edge::right && !certainly_less(s, bend.v)) {
            const Ball y = Field<Ball>::root(clamped(s - bend.v) * (s + bend.v));
            sum += f(bend, y, atan2(y, bend.v));
        }
    }
    return sum;
}

// docs/axisymmetric.md, "Piecewise linear slopes"
Ball AxisymmetricContact::approach_at(const Ball& s) const {
    return s * over_bends(s, [](const Bend& bend, const Ball& y, const Ball& A) {
               return bend.jump * A + bend.rate * (y - bend.v * A);
           });
}

Ball AxisymmetricContact::approach_rate(const Ball& s) const {
    return over_bends(s, [](const Bend& bend, const Ball& y, const Ball& A) {
        Ball rate = bend.rate * (y * 2 - bend.v * A);
        if (!contains_zero(bend.jump)) {
            rate += bend.jump * (A + bend.v / y);
        }
        return rate;
    });
}

Ball AxisymmetricContact::force_at(const Ball& a) const {
    return modulus_ * over_bends(a, [&](const Bend& bend, const Ball& y, const Ball& A) {
               const Ball& v = bend.v;
               return bend.jump * (a * a * A + v * y) +
                      bend.rate * (y * y * y * 4 / 3 - v * (a * a * A - v * y));
           });
}

Ball AxisymmetricContact::approach() const { return approach_at(a_); }

Ball AxisymmetricContact::force_rate() const { return modulus_ * a_ * approach_rate(a_) * 2; }

Ball AxisymmetricContact::minimum_end() const {
    for (const Bend& bend : bends_) {
        if (!contains_zero(bend.jump) || !contains_zero(bend.rate)) {
            return bend.v;
        }
    }
    return {0, bits_};
}

bool AxisymmetricContact::inside(std::size_t knot) const {
    return !on_edge_[knot] && !certainly_less(a_, abs(slope_.knots[knot]));
}

} // namespace edgeproof::contact
