// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/formula/expr.hpp"

#include <string_view>

namespace edgeproof::formula {

/// Whether e(-x) is e(x), or -e(x), wherever both are defined, `variable` being x: told by the form
/// of e, from the parts up. What does not have x in it is even.
enum class Parity {
    even,
    odd,
    undecided, ///< by the form: e may still be either
};
[[nodiscard]] Parity parity(const Expr& e, std::string_view variable);

/// Whether e is shown by its form to be an odd function and a constant: e(x) + e(-x) = 2 e(0).
/// False says that the form does not show it, not that it is false.
[[nodiscard]] bool odd_but_for_a_constant(const Expr& e, std::string_view variable);

} // namespace edgeproof::formula
