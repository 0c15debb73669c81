// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/spots.hpp"

namespace edgeproof {

/// Of a formula that was found without a value at a spot: whether that is a root or a logarithm of
/// a number that is negative, or full-stick traction at a place beyond the contact, and whether by
/// more than 1e-20 of the terms that the number is the sum of, where some hundred digits are
/// carried; in an integral, at one of some places within its limits. An estimate.
[[nodiscard]] Undefined why_undefined(const Expr& e, const Spot& spot);

} // namespace edgeproof
