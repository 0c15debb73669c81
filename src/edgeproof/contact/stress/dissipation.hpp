// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/contact/slip/ball_slip.hpp"

#include <array>
#include <functional>
#include <vector>

/// The energy that friction dissipates, in balls (docs/histories.md, "The energy").
namespace edgeproof::contact {

/// A part of a load step in which one zone slips in one direction: the zone outside the contact
/// under L_s. L_s and P change linearly in time. Forces: force/length.
struct SlipPhase {
    Ball inner_from; ///< L_s at the beginning
    Ball inner_to;   ///< L_s at the end, less than at the beginning
    Ball force_from; ///< P at the beginning
    Ball force_to;
    Ball change; ///< |dQ -+ f dP| for slip in the direction +- of Q
    /// The forces above, ascending, without repetition; each with the zone that is the contact
    /// under it.
    struct Cut {
        Ball force;
        BallZone zone;
    };
    std::vector<Cut> cuts;
};

/// The integral over the time of a phase, 0 to 1, of P - L as long as L_s < L < P: between two cuts
/// W = c0 + c1 x + c2 x^2 with x = L - at (force/length).
struct PhaseWeight {
    Ball at;
    std::array<Ball, 3> c;

    template <class L> [[nodiscard]] L operator()(const L& force) const {
        const L x = force + (-at);
        return (x * c[2] + c[1]) * x + c[0];
    }
};

/// Returns the integral of a weight W(L) d ln D from one cut to the next one (force/length), where
/// D(L) is the length of the contact under the force L.
using GrowthIntegral = std::function<Ball(const PhaseWeight& weight, const SlipPhase::Cut& from,
                                          const SlipPhase::Cut& to)>;

/// For a profile with a piecewise linear slope (force_growth.hpp). The result refers to `contact`,
/// a contact of the family.
[[nodiscard]] GrowthIntegral growth_of(const BallContact& contact);

/// In closed form if the force L is proportional to D^power: `power` is m + 1 for a power law m,
/// and 1 for a wedge, tilted or not. The zones of the cuts are not used.
[[nodiscard]] GrowthIntegral similar_growth(const Ball& power);

/// Returns the energy per unit length (force) of phases,
///   2 f/(pi E*) times the sum of change times the mean over the phase of
///   the integral of (P - L) d ln D over L_s < L < P.
/// Proved. Throws BudgetError where the bits do not distinguish the forces.
/// @param modulus E* (stress)
/// @param friction f
/// @param phases of the history, in any order
/// @param integral the integral over the contacts of the family
[[nodiscard]] Ball dissipated_energy(const Ball& modulus, const Ball& friction,
                                     const std::vector<SlipPhase>& phases,
                                     const GrowthIntegral& integral);

/// Returns the energy per unit length that friction dissipates in a cycle of the shear force from
/// -|Q| to |Q| and back, with P held and no bulk tension (docs/partial-slip.md, "The energy of a
/// cycle"):
///   W = 8 f^2/(pi E*) times the integral of (P - L)(L - L_s) d ln D over L_s < L < P,
/// where L_s = P - |Q|/f. As dissipated_energy.
[[nodiscard]] Ball cycle_energy(const BallSlip& slip, const GrowthIntegral& integral);

} // namespace edgeproof::contact
