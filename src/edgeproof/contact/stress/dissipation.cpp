// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/stress/dissipation.hpp"

#include "edgeproof/contact/stress/force_growth.hpp"
#include "edgeproof/precision/error.hpp"

#include <array>
#include <cstddef>

namespace edgeproof::contact {
namespace {

using Cut = SlipPhase::Cut;

/// The weight between two cuts. Throws BudgetError if the bits do not distinguish the cuts.
PhaseWeight weight_between(const SlipPhase& s, const Ball& from, const Ball& to) {
    const Ball centre = (from + to) / 2;
    const auto beyond = [&](const Ball& force) { // centre > force
        if (!certainly_less(force, centre) && !certainly_less(centre, force)) {
            throw BudgetError("too few bits to distinguish the forces of a step");
        }
        return certainly_less(force, centre);
    };
    const Ball growth = s.force_to - s.force_from;
    const bool before_slip = !beyond(s.inner_from); // L_s has to decrease to L first
    const bool late = beyond(s.force_from);         // P has to increase to L first
    const bool ends = beyond(s.force_to);           // P decreases below L
    const auto at = [&](const Ball& L) {
        Ball begin(0, L.bits());
        Ball end(1, L.bits());
        if (before_slip) {
            begin = (s.inner_from - L) / (s.inner_from - s.inner_to);
        } else if (late) {
            begin = (L - s.force_from) / growth;
        }
        if (ends) {
            end = (L - s.force_from) / growth;
        }
        return (end - begin) * (s.force_from - L + growth * (begin + end) / 2);
    };
    const Ball half = (to - from) / 2;
    const Ball lower = at(from);
    const Ball mean = at(centre);
    const Ball upper = at(to);
    return {centre,
            {mean, (upper - lower) / (half * 2), (upper - mean * 2 + lower) / (half * half * 2)}};
}

/// c_0, c_1, c_2 of W = c_0 + c_1 L + c_2 L^2.
std::array<Ball, 3> about_zero(const PhaseWeight& w) {
    return {w(Ball(0, w.at.bits())), w.c[1] - w.c[2] * w.at * 2, w.c[2]};
}

} // namespace

GrowthIntegral growth_of(const BallContact& contact) {
    return [&contact](const PhaseWeight& weight, const Cut& from, const Cut& to) {
        const BallContact inner = contact.between(from.zone.a, from.zone.b);
        const BallContact outer = contact.between(to.zone.a, to.zone.b);
        const ForceGrowth lower = force_growth(inner, from.force);
        const ForceGrowth upper = force_growth(outer, to.force);
        const auto c = about_zero(weight);
        return c[0] * log1p((outer.length() - inner.length()) / inner.length()) +
               c[1] * (upper.first - lower.first) + c[2] * (upper.second - lower.second);
    };
}

// d ln D = dL/(power L)
GrowthIntegral similar_growth(const Ball& power) {
    return [power](const PhaseWeight& weight, const Cut& from, const Cut& to) {
        const Ball width = to.force - from.force;
        const auto c = about_zero(weight);
        return (c[0] * log1p(width / from.force) + c[1] * width +
                c[2] * width * (from.force + to.force) / 2) /
               power;
    };
}

Ball dissipated_energy(const Ball& modulus, const Ball& friction,
                       const std::vector<SlipPhase>& phases, const GrowthIntegral& integral) {
    Ball sum(0, modulus.bits());
    for (const SlipPhase& phase : phases) {
        Ball part(0, modulus.bits());
        for (std::size_t i = 0; i + 1 < phase.cuts.size(); ++i) {
            const Cut& from = phase.cuts[i];
            const Cut& to = phase.cuts[i + 1];
            part += integral(weight_between(phase, from.force, to.force), from, to);
        }
        sum += phase.change * part;
    }
    return sum * friction * 2 / (Ball::pi(modulus.bits()) * modulus);
}

// Both ways: Q changes by 2 |Q| = 2 f (P - L_s).
Ball cycle_energy(const BallSlip& slip, const GrowthIntegral& integral) {
    const Ball inner = slip.force() * (1 - slip.load_ratio());
    return dissipated_energy(slip.zones().modulus(), slip.friction(),
                             {{slip.force(),
                               inner,
                               slip.force(),
                               slip.force(),
                               slip.friction() * slip.force() * slip.load_ratio() * 4,
                               {{inner, slip.stick()}, {slip.force(), slip.whole()}}}},
                             integral);
}

// The integral of (P - L)(L - L_s) dL/L, divided by P^2: tau - tau^2/2 + (1 - tau) ln(1 - tau)
// (docs/partial-slip.md, "The energy of a cycle").
Ball similar_cycle_energy(const BallSlip& slip, const Ball& power) {
    const Ball& tau = slip.load_ratio();
    const Ball part = tau - tau * tau / 2 + (1 - tau) * log1p(-tau);
    return slip.friction() * slip.friction() * slip.force() * slip.force() * 8 * part /
           (Ball::pi(power.bits()) * slip.zones().modulus() * power);
}

} // namespace edgeproof::contact
