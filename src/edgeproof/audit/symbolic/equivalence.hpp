// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/symbolic/symbolic.hpp"
#include "edgeproof/formula/expr.hpp"

#include <string>

namespace edgeproof::audit {

/// Returns the text of an expression with sorted terms and factors. It is the same for two
/// expressions if they differ only in this order, in signs taken out of products, and in quotients
/// of quotients.
[[nodiscard]] std::string ordered_text(const formula::Expr& e);

/// True if two formulas (definitions put in) are proved to be equal: by the order of their terms,
/// with b = a for symmetric contacts; by symbols; or as principal values over the contact that
/// differ by a constant over w(s)(s - x), w(s) = sqrt((a - s)(s + b)), whose principal value is
/// zero. False means that no proof was found.
[[nodiscard]] bool surely_equal(const formula::Expr& x, const formula::Expr& y,
                                const SymbolicCase& under);

} // namespace edgeproof::audit
