// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/slip/ball_slip.hpp"
#include "edgeproof/contact/enclosure/ball_marks.hpp"
#include "edgeproof/contact/enclosure/ball_values.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace edgeproof::contact {
namespace {

constexpr int most_limit_steps = 400;

} // namespace

BallSlip::BallSlip(const ProvedContact& contact, const ZoneSolver& zones, const Ball& force,
                   const ShearLoad<Ball>& load, const Ball& friction,
                   const std::optional<BallZone>& stick)
    : contact_(contact), zones_(zones), whole_{contact.a(), contact.b()}, force_(force),
      friction_(friction), direction_(sgn(load.Q)), over_Q_(load.bulk_tension / load.Q),
      ratio_(abs(load.Q) / (friction * force)) {
    const Ball left = 1 - ratio_;
    if (certainly_positive(left)) {
        stick_ = stick ? *stick : zones_.zone(force_ * left, tilt_at(ratio_), whole_);
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
    Ball x = middle(whole_.at(opposite(edge)));
    const long bits = zones_.bits();
    const Ball tiny = power_of_two(24 - bits, bits);
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
        const Ball slack = whole_.length() * power_of_two(lost - bits, bits);
        const Ball lo = lower_end(x - slack);
        const Ball hi = upper_end(x + slack);
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

// The sum of the parts: q = f (p - p*) in the direction of Q after one step of Q
// (docs/partial-slip.md, "The corrective contact"), and docs/histories.md.
Ball BallSlip::traction(Edge edge, const Ball& u, const Ball& p) const {
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
                                          within ? depth : clamped(depth));
    }
    return q;
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

namespace {

constexpr std::size_t most_energy_panels = 20'000;

/// Returns 8 f^2/(pi E*) (docs/partial-slip.md, "The energy of a cycle").
Ball energy_factor(const BallSlip& slip) {
    const ZoneSolver& zones = slip.zones();
    return slip.friction() * slip.friction() * 8 / (Ball::pi(zones.bits()) * zones.modulus());
}

/// The contact of the profile with the half-length a, and its force.
struct Inner {
    Ball a;
    Ball force;
};

/// The integral of (P - L)(L - L_s) d ln D (docs/partial-slip.md, "The energy of a cycle").
class CycleIntegral {
public:
    CycleIntegral(const BallContact& contact, const BallSlip& slip)
        : contact_(contact), bits_(contact.bits()), most_(slip.force()),
          least_(slip.force() * (1 - slip.load_ratio())), inner_{slip.stick().a, least_},
          outer_{slip.whole().a, most_}, terms_(2 * (static_cast<std::size_t>(bits_) / 8) + 1) {
        const Ball range = most_ - least_;
        enough_ = middle(range * range * stretch(inner_, outer_) *
                         power_of_two(bits_ / 8 - bits_, bits_));
    }

    [[nodiscard]] Ball total() const {
        const Inner lo = at(upper_end(inner_.a));
        const Inner hi = at(lower_end(outer_.a));
        if (!certainly_less(lo.a, hi.a)) {
            throw BudgetError("too few bits to distinguish the stick zone from the contact");
        }
        Ball sum = between_ends(inner_, lo) + between_ends(hi, outer_);
        std::vector<std::pair<Inner, Inner>> panels{{lo, hi}};
        for (std::size_t count = 0; !panels.empty(); ++count) {
            check_interruption();
            if (count > most_energy_panels) {
                throw BudgetError("the energy of a cycle takes too many panels");
            }
            const auto [from, to] = std::move(panels.back());
            panels.pop_back();
            const Ball centre = middle((from.a + to.a) / 2);
            const bool divisible = certainly_less(from.a, centre) && certainly_less(centre, to.a);
            const Ball crude = between_ends(from, to);
            if (!divisible || certainly_less(Ball(crude.radius(), bits_), enough_)) {
                sum += crude;
            } else if (const auto fine = by_taylor(from, centre, to)) {
                sum += *fine;
            } else {
                const Inner between = at(centre);
                panels.emplace_back(between, to);
                panels.emplace_back(from, between);
            }
        }
        return sum;
    }

private:
    [[nodiscard]] Inner at(const Ball& a) const { return {a, contact_.between(a, a).force()}; }
    /// Returns ln(a_to/a_from).
    [[nodiscard]] static Ball stretch(const Inner& from, const Inner& to) {
        return log1p((to.a - from.a) / from.a);
    }
    /// Bounds the integral over a panel; L increases with the edge.
    [[nodiscard]] Ball between_ends(const Inner& from, const Inner& to) const {
        const Ball L = Ball::hull(from.force, to.force);
        return clamped(most_ - L) * clamped(L - least_) * clamped(stretch(from, to));
    }
    /// The integral over a panel; nothing if the remainder is not small enough.
    [[nodiscard]] std::optional<Ball> by_taylor(const Inner& from, const Ball& centre,
                                                const Inner& to) const {
        const Ball lo = from.a - centre;
        const Ball hi = to.a - centre;
        // The integrals of z^k. The last power is even, so that the remainder is a value of the
        // last coefficient times its integral (Taylor's theorem and the mean value theorem).
        Ball lo_power = lo;
        Ball hi_power = hi;
        std::vector<Ball> moments;
        for (std::size_t k = 0; k < terms_; ++k) {
            moments.push_back((hi_power - lo_power) / static_cast<long>(k + 1));
            lo_power *= lo;
            hi_power *= hi;
        }
        const Ball remainder = integrand(Ball::hull(from.a, to.a))[terms_ - 1] * moments.back();
        if (!remainder.is_finite() || !certainly_less(abs(remainder), enough_)) {
            return {};
        }
        const BallSeries f = integrand(centre);
        Ball sum = remainder;
        for (std::size_t k = 0; k + 1 < terms_; ++k) {
            sum += f[k] * moments[k];
        }
        return sum.is_finite() ? std::optional(sum) : std::nullopt;
    }
    /// Returns the Taylor series of (P - L)(L - L_s)/a in a.
    [[nodiscard]] BallSeries integrand(const Ball& a) const {
        const BallContact c = contact_.between(a, a);
        const BallSeries rate = c.total_rate_series(terms_);
        BallSeries L(c.force(), terms_);
        for (std::size_t k = 1; k < terms_; ++k) {
            L.set(k, rate[k - 1] / static_cast<long>(k));
        }
        return (-L + most_) * (L + (-least_)) / BallSeries::variable(a, terms_);
    }

    const BallContact& contact_;
    long bits_;
    Ball most_;  ///< P
    Ball least_; ///< P - |Q|/f
    Inner inner_;
    Inner outer_;
    std::size_t terms_; ///< odd
    Ball enough_;
};

} // namespace

Ball cycle_energy(const BallContact& contact, const BallSlip& slip) {
    return energy_factor(slip) * CycleIntegral(contact, slip).total();
}

// The integral of (P - L)(L - L_s) dL/L, divided by P^2: tau - tau^2/2 + (1 - tau) ln(1 - tau)
// (docs/partial-slip.md, "The energy of a cycle").
Ball similar_cycle_energy(const BallSlip& slip, const Ball& power) {
    const Ball& tau = slip.load_ratio();
    const Ball part = tau - tau * tau / 2 + (1 - tau) * log1p(-tau);
    return energy_factor(slip) * slip.force() * slip.force() * part / power;
}

} // namespace edgeproof::contact
