// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/formula/expr.hpp"

#include <optional>

namespace edgeproof::formula {

/// Whether e is proved to be zero by exact algebra: e is brought to a quotient of polynomials with
/// rational coefficients in pi, roots of primes, and whatever else occurs (names, other functions),
/// each of these a variable of its own, with sqrt(y)^2 = y and acos(-y) = pi - acos(y). A constant
/// has to be finite in ball arithmetic as well, so that nothing was divided by zero. False says
/// that no proof was found, not that e differs from zero.
[[nodiscard]] bool proved_zero(const Expr& e);

/// The sign of a constant: by balls of up to `bits` bits, or 0 by proved_zero. Nothing where
/// neither tells, or where e has no real value.
[[nodiscard]] std::optional<int> decided_sign(const Expr& e, long bits = 2048);

} // namespace edgeproof::formula
