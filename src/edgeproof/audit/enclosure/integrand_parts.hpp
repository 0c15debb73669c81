// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/enclosure/contact_formulas.hpp"
#include "edgeproof/formula/expr.hpp"

#include <optional>
#include <string>
#include <vector>

/// Properties of an integrand as it is written.
namespace edgeproof::audit {

/// True if a function of the contact, such as p, occurs: a call that is not built in.
[[nodiscard]] bool holds_function(const formula::Expr& e);

/// True for |g1(x)|, whose formula depends on the piece as that of g1 does.
[[nodiscard]] bool is_size_of_slope(const formula::Expr& e);

/// True if p occurs with an argument that contains the variable.
[[nodiscard]] bool holds_pressure(const formula::Expr& e, const std::string& variable);

/// The degree of e in p(variable) if all other factors are entire functions of the variable: sums,
/// products, whole powers, exp, sin, cos. The variable may not occur in a divisor.
[[nodiscard]] std::optional<int> degree_in_pressure(const formula::Expr& e,
                                                    const std::string& variable);

/// Returns the argument of the first P1of or bof that contains the variable.
[[nodiscard]] std::optional<formula::Expr> contact_argument(const formula::Expr& e,
                                                            const std::string& variable);

/// A value of the variable at which a function of the contact changes its formula.
struct IntegrandCut {
    formula::Expr at;
    bool of_contacts; ///< for P1of and bof, whose argument is a contact's right edge
};
/// Returns the cuts, unordered, inside the interval or not.
[[nodiscard]] std::vector<IntegrandCut>
integrand_cuts(const formula::Expr& f, const std::string& variable, const ContactFormulas& contact);

/// True if e is proved to vanish for all values of its names, where b^{-1} is the inverse of the
/// law b of the left edge, and b(y) = y, b = a for a symmetric contact. Applies to sums, products,
/// quotients and integer powers of names, numbers and functions of the contact. False means that no
/// proof was found.
[[nodiscard]] bool surely_zero(const formula::Expr& e, bool symmetric);

} // namespace edgeproof::audit
