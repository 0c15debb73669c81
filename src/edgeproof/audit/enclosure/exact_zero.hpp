// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/formula/expr.hpp"

namespace edgeproof::audit {

/// Whether e is proved to vanish for all values of its names, b^{-1} being the inverse of the left
/// edge's law b, and b(y) = y, b = a for a symmetric contact. Decided for sums, products, quotients
/// and whole powers of names, numbers and functions of the contact; false says that no proof was
/// found.
[[nodiscard]] bool surely_zero(const formula::Expr& e, bool symmetric);

} // namespace edgeproof::audit
