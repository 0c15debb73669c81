// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/slip/ball_slip.hpp"

#include "edgeproof/contact/enclosure/ball_marks.hpp"
#include "edgeproof/precision/error.hpp"

namespace edgeproof::contact {
namespace {

constexpr int most_limit_steps = 400;

} // namespace

BallSlip::BallSlip(const ProvedPressure& contact, const ZoneSolver& zones, const Ball& force,
                   const ShearLoad<Ball>& load, const Ball& friction,
                   const std::optional<BallZone>& stick)
    : contact_(contact), zones_(zones), whole_{contact.a(), contact.b()}, force_(force),
      friction_(friction), direction_(sgn(load.Q)), over_Q_(load.bulk_tension / load.Q),
      ratio_(abs(load.Q) / (friction * force)) {
    const Ball left = 1 - ratio_;
    if (certainly_positive(left)) {
        stick_ = stick ? *stick : zones_.zone(force_ * left, tilt_at(ratio_), whole_);
    } else if (contains_zero(left) && !left.is_exact()) {
        throw BudgetError("too few bits to distinguish |Q| from f P");
    }
}

// delta = sigma_0 sgn(Q)/(2 f E*) = (sigma_0/Q) tau P/(2 E*) (docs/partial-slip.md, "The corrective
// contact").
Ball BallSlip::tilt_at(const Ball& tau) const {
    return over_Q_ * tau * force_ / (zones_.modulus() * 2);
}

BallZone BallSlip::stick_at(const Ball& tau, const BallZone& near) const {
    return zones_.zone(force_ * (1 - tau), tilt_at(tau), near);
}

// da_s/dtau = -P (1 + pi (sigma_0/Q) D_s/8)/(dP/da) (docs/partial-slip.md, "The series").
Ball BallSlip::rate_between(const BallZone& outer, const BallZone& inner, Edge edge) const {
    const BallZone box{Ball::hull(outer.a, inner.a), Ball::hull(outer.b, inner.b)};
    const Ball turn =
        Ball::pi(zones_.bits()) * over_Q_ * Ball::hull(outer.length(), inner.length()) / 8;
    const Ball share = edge == Edge::right ? 1 + turn : 1 - turn;
    return force_ * share / zones_.values(box).rate(edge);
}

// d at most reaches the minimum of g' without a tilt, or the other edge of the stick zone
Ball BallSlip::sizes_to_sliding(const BallZone& from, Edge edge) const {
    const bool upright = over_Q_.is_exact() && contains_zero(over_Q_);
    const Ball innermost = upright ? zones_.core().at(edge) : -from.at(opposite(edge));
    return Ball::hull(whole_.at(edge) - from.at(edge), whole_.at(edge) - innermost);
}

// |sigma_0/Q| D < 8/pi at this edge (docs/partial-slip.md, "When it holds")
bool BallSlip::slips_from_the_first(Edge edge) const {
    const Ball turn = Ball::pi(zones_.bits()) * over_Q_ * whole_.length() / 8;
    return certainly_positive(edge == Edge::right ? 1 + turn : 1 - turn);
}

// docs/partial-slip.md, "When it holds": F increases with the free edge, which is found by Newton's
// method and enclosed by the signs on both sides.
Ball BallSlip::tension_limit(Edge edge) const {
    const Ball P = force_ * (1 - ratio_);
    const auto zone_to = [&](const Ball& other) {
        return edge == Edge::left ? BallZone{other, whole_.b} : BallZone{whole_.a, other};
    };
    const auto middle = [](const Ball& x) { return Ball(x.midpoint(), x.bits()); };
    Ball x = middle(whole_.at(opposite(edge)));
    const long bits = zones_.bits();
    const Ball tiny(Rational(1, Integer(1) << static_cast<unsigned>(bits - 24)), bits);
    for (int k = 0; k < most_limit_steps; ++k) {
        const ZoneValues v = zones_.values(zone_to(x));
        Ball step = middle((v.force - P) / v.rate(opposite(edge)) * 2);
        if (!step.is_finite()) {
            break;
        }
        const Ball limit = zone_to(x).length() * Ball(Rational(7, 8), bits);
        if (certainly_less(limit, step)) {
            step = limit;
        }
        x = middle(x - step);
        if (!certainly_less(tiny * whole_.length(), abs(step))) {
            break;
        }
    }
    for (long lost = 24; lost < bits; lost += 24) {
        const Ball slack =
            whole_.length() *
            Ball(Rational(1, Integer(1) << static_cast<unsigned>(bits - lost)), bits);
        const Ball lo(Ball(x - slack).lower(), bits);
        const Ball hi(Ball(x + slack).upper(), bits);
        if (certainly_less(zones_.values(zone_to(lo)).force, P) &&
            certainly_less(P, zones_.values(zone_to(hi)).force)) {
            const Ball tilt = -zones_.values(zone_to(Ball::hull(lo, hi))).mean_slope;
            return direction_ * tilt * friction_ * zones_.modulus() * 2;
        }
    }
    throw BudgetError("too few bits to enclose the limit of the bulk tension");
}

SlipState BallSlip::state(Edge edge, const Ball& u) const {
    const Ball beyond = u - size(edge);
    const Ball before = stick_->length() - beyond;
    if (certainly_negative(beyond) || certainly_negative(before)) {
        return SlipState::slip;
    }
    return certainly_positive(beyond) && certainly_positive(before) ? SlipState::stick
                                                                    : SlipState::undecided;
}

// q = f (p - p*) in the direction of Q (docs/partial-slip.md, "The corrective contact")
Ball BallSlip::traction(Edge edge, const Ball& u, const Ball& p) const {
    const SlipState where = state(edge, u);
    if (where == SlipState::slip) {
        return direction_ * friction_ * p;
    }
    const Ball inside = u - size(edge);
    if (where == SlipState::stick) {
        return direction_ * friction_ * (p - zones_.pressure(*stick_, edge, inside));
    }
    // At an edge of the stick zone, as far as the bits decide: p* is 0 beyond it.
    const bool this_edge = contains_zero(inside);
    const Edge there = this_edge ? edge : opposite(edge);
    const Ball depth = clamped(this_edge ? inside : stick_->length() - inside);
    const Ball most = zones_.pressure(*stick_, there, depth);
    return direction_ * friction_ * (p - most);
}

// docs/partial-slip.md, "The series"
SlipSeries<Ball> BallSlip::series(std::size_t terms) const {
    const long bits = zones_.bits();
    const Ball D = whole_.length();
    const Ball root_D = sqrt(D);
    return slip_series<Ball>(contact_.expansion(Edge::right, terms),
                             contact_.expansion(Edge::left, terms), D,
                             force_ * 2 / (Ball::pi(bits) * root_D),
                             force_ * over_Q_ / (root_D * 4), terms, Ball(1, bits));
}

} // namespace edgeproof::contact
