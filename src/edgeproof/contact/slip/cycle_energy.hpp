// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/contact/slip/ball_slip.hpp"
#include "edgeproof/precision/ball/ball.hpp"

namespace edgeproof::contact {

/// Returns the energy per unit length that friction dissipates in a cycle of the shear force from
/// -|Q| to |Q| and back, with P held and no bulk tension (docs/partial-slip.md, "The energy of a
/// cycle"):
///   W = 8 f^2/(pi E*) times the integral of (P - L)(L - L_s) d ln D over L_s < L < P,
/// where D(L) is the length of the contact under the force L, and L_s = P - |Q|/f. Proved, for
/// symmetric profiles with piecewise linear slopes: by a Taylor polynomial on each panel of a, with
/// the remainder from the coefficient over the panel, and next to knots by monotonicity. Throws
/// BudgetError where that takes too many panels.
[[nodiscard]] Ball cycle_energy(const BallContact& contact, const BallSlip& slip);

/// The same in closed form if the force L is proportional to D^power: `power` is m + 1 for a power
/// law m, and 1 for a wedge, tilted or not.
[[nodiscard]] Ball similar_cycle_energy(const BallSlip& slip, const Ball& power);

} // namespace edgeproof::contact
