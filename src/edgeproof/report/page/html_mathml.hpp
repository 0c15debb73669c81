// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/formula/expr.hpp"

#include <string>

namespace edgeproof::report {

/// The expression as presentation MathML (the content of `<math>`, one `<mrow>`): fractions, roots
/// and powers are set as such; P1, b2, Es, right_c1, gam and Greek names as the paper writes them.
/// The tree is shown as it is: no parentheses are lost, none are added but those it needs.
[[nodiscard]] std::string to_mathml(const formula::Expr& e);

/// `<math>` around it, as a block.
[[nodiscard]] std::string math_element(const std::string& content, const std::string& label);

} // namespace edgeproof::report
