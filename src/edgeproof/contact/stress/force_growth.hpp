// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/precision/ball/ball.hpp"

namespace edgeproof::contact {

/// Integrals over the contacts of a profile under the forces up to L, in closed form
/// (docs/partial-slip.md, "The energy of a cycle"). D is the length of a contact. Only differences
/// of `first` between contacts of the profile have a meaning: the integral begins at no contact.
struct ForceGrowth {
    Ball first;  ///< of L d ln D (force/length)
    Ball second; ///< of L^2 d ln D (force/length, squared)
};

/// Enclosed. Between neighbouring contacts the differences lose bits, and the caller uses more.
/// @param contact a contact, or a zone of its profile, with a piecewise linear slope
/// @param force L (force/length)
[[nodiscard]] ForceGrowth force_growth(const BallContact& contact, const Ball& force);

} // namespace edgeproof::contact
