// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/contact/slip/ball_slip.hpp"
#include "edgeproof/contact/enclosure/ball_values.hpp"
#include "edgeproof/contact/enclosure/fields.hpp"
#include "edgeproof/contact/enclosure/isolate_zero.hpp"
#include "edgeproof/precision/ball/ball_series.hpp"
#include "edgeproof/precision/error.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace edgeproof::contact {
BallSlip::BallSlip(const ProvedContact& contact, const ZoneSolver& zones, const Ball& force,
                   const ShearLoad<Ball>& load, const Ball& friction,
                   const std::optional<BallZone>& stick)
    : contact_(contact), zones_(zones), whole_{contact.a(), contact.b()}, force_(force),
      friction_(friction), direction_(sgn(load.Q)), over_Q_(load.bulk_tension / load.Q),
      ratio_(abs(load.Q) / (friction * force)) {
    const Ball left = 1 - ratio_;
    if (certainly_positive(left)) {
        const Ball F = force_ * left;
        const Ball tilt = tilt_at(ratio_);
        std::optional<BallZone> found;
        if (!stick && !contains_zero(over_Q_)) {
            try {
                found = zones_.equations(F, tilt).search(whole_);
            } catch (const BudgetError&) {
                look_beyond(load.bulk_tension); // before a longer search, which may not end
                if (beyond_) {
                    return;
                }
            }
        }
        stick_ = stick   ? *stick
                 : found ? zones_.equations(F, tilt).proved(*found)
                         : zones_.zone(F, tilt, whole_);
        for (const Edge edge : {Edge::right, Edge::left}) {
            if (certainly_negative(size(edge))) {
                beyond_ = edge;
            }
        }
        whole_ratio_ = direction_ * friction_;
        parts_.push_back({-whole_ratio_, *stick_});
    } else if (contains_zero(left) && !left.is_exact()) {
        throw BudgetError("too few bits to distinguish |Q| from f P");
    }
}

BallSlip::BallSlip(const ProvedContact& contact, const ZoneSolver& zones, const Ball& Q,
                   const Ball& friction, const std::vector<ShearLayer>& layers,
                   const std::optional<Ball>& stick)
    : contact_(contact), zones_(zones), whole_{contact.a(), contact.b()},
      force_(layers.back().force), friction_(friction), direction_(sgn(Q)),
      over_Q_(0, zones.bits()), ratio_(abs(Q) / (friction * force_)), stick_(whole_),
      sticks_(!stick), whole_ratio_(layers.back().ratio) {
    const auto zone_of = [&](const Ball& force) { return zones_.zone(force, over_Q_, whole_); };
    for (std::size_t j = 0; j + 1 < layers.size(); ++j) {
        parts_.push_back({layers[j].ratio - layers[j + 1].ratio, zone_of(layers[j].force)});
    }
    if (stick) {
        stick_ = zone_of(*stick);
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
    return force_ * share / zones_.rates(box).at(edge);
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

// docs/partial-slip.md, "When it holds": F increases with the length of the zone that begins at an
// edge of the contact, at half the rate dP/da of its free edge.
Ball BallSlip::tension_limit(Edge edge) const {
    const Ball P = force_ * (1 - ratio_);
    const Ball& fixed = whole_.at(edge);
    const auto zone = [&](const Ball& length) {
        return edge == Edge::left ? BallZone{length - fixed, fixed}
                                  : BallZone{fixed, length - fixed};
    };
    const Ball length =
        isolate_zero([&](const Ball& D) { return P - zones_.values(zone(D)).force; },
                     [&](const Ball& D) { return -zones_.rates(zone(D)).at(opposite(edge)) / 2; },
                     whole_.length(), "the limit of the bulk tension");
    const Ball tilt = -zones_.values(zone(length)).mean_slope;
    return direction_ * tilt * friction_ * zones_.modulus() * 2;
}

// Without a bulk tension the stick zone lies within the contact: the limits have opposite signs.
void BallSlip::look_beyond(const Ball& tension) {
    const Edge edge = certainly_positive(over_Q_) ? Edge::left : Edge::right;
    try {
        if (certainly_less(abs(tension_limit(edge)), abs(tension))) {
            beyond_ = edge;
        }
    } catch (const BudgetError&) {
        // More bits may decide.
    }
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

// The sum of the parts: q = f (p - p*) in the direction of Q after one step of Q
// (docs/partial-slip.md, "The corrective contact"), and docs/histories.md.
Ball BallSlip::traction(Edge edge, const Ball& u, const Ball& p,
                        const std::optional<Exact>& x) const {
    Ball q = whole_ratio_ * p;
    for (const ShearPart& part : parts_) {
        const Ball inside = u - (whole_.at(edge) - part.zone.at(edge));
        const Ball before = part.zone.length() - inside;
        if (certainly_negative(inside) || certainly_negative(before)) {
            continue; // the pressure of the zone is 0 there
        }
        // At an edge of the zone, as far as the bits decide, the pressure is 0 beyond it.
        const bool within = certainly_positive(inside) && certainly_positive(before);
        const bool this_edge = within || contains_zero(inside);
        const Ball& depth = this_edge ? inside : before;
        q += part.ratio * zones_.pressure(part.zone, this_edge ? edge : opposite(edge),
                                          within ? depth : clamped(depth),
                                          within ? x : std::nullopt);
    }
    return q;
}

// docs/partial-slip.md, "The series"
SlipSeries BallSlip::series(std::size_t terms) const {
    const long bits = zones_.bits();
    const std::vector<Ball> rates = zones_.force_rates(whole_.a, terms);
    if (!rates.empty()) {
        // The integral of the rates over the slip zone is tau P.
        BallSeries over_force(Ball(0, bits), terms + 1);
        for (std::size_t k = 0; k < terms; ++k) {
            over_force.set(k + 1, rates[k] / (force_ * static_cast<long>(k + 1)));
        }
        const BallSeries d = inverse_function(over_force);
        SlipSeries series;
        for (std::size_t k = 1; k <= terms; ++k) {
            series.right.push_back(d[k]);
        }
        series.left = series.right;
        return series;
    }
    const Ball D = whole_.length();
    const Ball root_D = sqrt(D);
    return slip_series(
        contact_.expansion(Edge::right, terms), contact_.expansion(Edge::left, terms), D,
        force_ * 2 / (Ball::pi(bits) * root_D), force_ * over_Q_ / (root_D * 4), terms);
}

} // namespace edgeproof::contact
