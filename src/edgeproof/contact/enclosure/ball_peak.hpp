// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/enclosure/proved_pressure.hpp"

namespace edgeproof::contact {

/// Returns an enclosure of the greatest pressure of a contact (docs/pressure.md, "The greatest
/// pressure"), in the unit of the contact modulus. The pressure is bounded over intervals of the
/// contact. They are halved, and dropped where the pressure is certainly less than at another
/// place, or certainly monotone. Where p is certainly concave over all remaining intervals, the
/// interval form of Newton's method encloses the one place where p' = 0. Otherwise (for example two
/// equal maxima) the bounds of the remaining intervals are the result, an enclosure that is wider
/// than the bits allow.
///
/// `symmetric`: p is even about the middle of the contact. The pressure must have no corner inside.
/// Throws BudgetError if the pressure is not bounded over some interval.
[[nodiscard]] Ball enclosed_peak(const ProvedPressure& contact, bool symmetric);

} // namespace edgeproof::contact
