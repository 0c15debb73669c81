// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/enclosure/proved_pressure.hpp"

namespace edgeproof::contact {

/// The greatest pressure of a contact, enclosed: the pressure is bounded over intervals of the
/// contact, which are halved and left out where they cannot hold the greatest one, since it is
/// certainly less than at another place, or certainly monotone. Where p is certainly concave over
/// what is left, the interval form of Newton's method narrows the one place where p' = 0. Where
/// that is not so (two places as high as each other), what the intervals tell remains, an enclosure
/// that is wider than the bits allow.
///
/// `symmetric`: p is even about the middle of the contact. The pressure has no corner inside.
/// Throws BudgetError where nothing is told.
[[nodiscard]] Ball enclosed_peak(const ProvedPressure& contact, bool symmetric);

} // namespace edgeproof::contact
