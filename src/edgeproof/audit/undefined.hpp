// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/spots.hpp"

namespace edgeproof {

/// Whether a formula that was found without a value at a spot has none by more than roundoff: the
/// root or logarithm of a number that is negative, or full-stick traction at a place beyond the
/// contact, by more than 1e-20 of the terms that it is the sum of, where some hundred digits are
/// carried; in an integral, at one of some places within its limits. An estimate. False where none
/// is found.
[[nodiscard]] bool undefined_beyond_roundoff(const Expr& e, const Spot& spot);

} // namespace edgeproof
