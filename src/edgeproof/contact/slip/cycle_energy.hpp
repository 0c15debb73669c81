// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/contact/slip/ball_slip.hpp"
#include "edgeproof/precision/ball/ball.hpp"

namespace edgeproof::contact {

/// The energy per unit length that friction takes in a cycle of the shear force, from -|Q| to |Q|
/// and back, P held, no bulk tension (docs/partial-slip.md, "The energy of a cycle"):
///     W = 8 f^2/(pi E*) times the integral of (P - L)(L - L_s) d ln D over L_s < L < P,
/// D(L) being the length of the contact under the force L and L_s = P - |Q|/f. Proved. For
/// symmetric profiles with piecewise linear slopes: a Taylor polynomial of each panel of a, its
/// remainder by the coefficient over the panel, and next to knots the bounds by monotonicity.
/// Throws BudgetError where that takes too many panels.
[[nodiscard]] Ball cycle_energy(const BallContact& contact, const BallSlip& slip);

/// The same in closed form, where D goes with a power of the force: L proportional to D^power,
/// m + 1 for a power law m, 1 for a wedge, tilted or not.
[[nodiscard]] Ball similar_cycle_energy(const BallSlip& slip, const Ball& power);

} // namespace edgeproof::contact
