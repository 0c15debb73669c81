// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/formula/expr.hpp"

#include <string_view>

namespace edgeproof::formula {

/// The parity of e as a function of x (`variable`), wherever both e(x) and e(-x) are defined. It is
/// derived from the form of e, from the parts upwards. An expression without x is even.
enum class Parity {
    even,
    odd,
    undecided, ///< not visible from the form: e may still be even or odd
};
[[nodiscard]] Parity parity(const Expr& e, std::string_view variable);

/// True if the form of e shows that it is the sum of an odd function and a constant:
/// e(x) + e(-x) = 2 e(0). False means only that the form does not show it.
[[nodiscard]] bool odd_but_for_a_constant(const Expr& e, std::string_view variable);

} // namespace edgeproof::formula
