// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/formula/expr.hpp"

#include <optional>

namespace edgeproof::formula {

/// True if e is proved to be zero by exact algebra. e is transformed to a quotient of polynomials
/// with rational coefficients in pi, roots of primes, and all other parts (names, other functions),
/// each of them a separate variable, with sqrt(y)^2 = y, acos(-y) = pi - acos(y), log(1) = 0 and
/// abs(q) for a rational q. A constant
/// must also be finite in ball arithmetic, so that there is no division by zero. False means only
/// that no proof was found.
[[nodiscard]] bool proved_zero(const Expr& e);

/// Returns the sign of a constant, by balls of up to `bits` bits, or 0 by proved_zero. Nothing if
/// neither decides, or if e has no real value.
[[nodiscard]] std::optional<int> decided_sign(const Expr& e, long bits = 2048);

} // namespace edgeproof::formula
