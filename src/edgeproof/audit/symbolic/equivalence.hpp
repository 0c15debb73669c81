// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/symbolic/symbolic.hpp"
#include "edgeproof/formula/expr.hpp"

#include <string>

namespace edgeproof::audit {

/// The text of an expression with its terms and factors in an order of their own: the same for
/// expressions that differ in that order, in signs carried out of products, in quotients of
/// quotients, and in nothing else.
[[nodiscard]] std::string ordered_text(const formula::Expr& e);

/// Whether two formulas (definitions put in) are proved to be equal: by the order of their terms, b
/// = a put in for symmetric contacts; by symbols; or as principal values over the contact that
/// differ by a constant over w(s)(s - x), w(s) = sqrt((a - s)(s + b)), whose principal value is
/// zero. False says that no proof was found.
[[nodiscard]] bool surely_equal(const formula::Expr& x, const formula::Expr& y,
                                const SymbolicCase& under);

} // namespace edgeproof::audit
