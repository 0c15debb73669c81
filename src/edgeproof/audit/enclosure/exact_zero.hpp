// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/formula/expr.hpp"

namespace edgeproof::audit {

/// True if e is proved to vanish for all values of its names, where b^{-1} is the inverse of the
/// law b of the left edge, and b(y) = y, b = a for a symmetric contact. Applies to sums, products,
/// quotients and integer powers of names, numbers and functions of the contact. False means that no
/// proof was found.
[[nodiscard]] bool surely_zero(const formula::Expr& e, bool symmetric);

} // namespace edgeproof::audit
