// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/formula/expr.hpp"
#include "edgeproof/precision/ball/ball.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

/// Properties of an integrand as it is written.
namespace edgeproof::audit {

using formula::Expr;

class ContactFormulas;

/// What is known of the law b of the left edge in symbols, in addition to its inverse.
enum class EdgeLaw {
    any,
    linear,   ///< b(s) is a multiple of s: b'' = 0
    symmetric ///< b(s) = s
};

/// The context of an integral.
struct IntegralSurroundings {
    /// Returns the value of a formula without the variable of the integral and without names of
    /// ContactFormulas.
    std::function<Ball(const Expr&)> value;
    /// Returns that value if it is a rational number.
    std::function<std::optional<Rational>(const Expr&)> rational;
    const ContactFormulas* contact = nullptr; ///< needed for functions of the contact
    EdgeLaw law = EdgeLaw::any;
    long bits = 0;
};

/// Returns the value of an integral(f, s, lo, hi) or pv(f, s, lo, hi, x) by Arb's rigorous
/// integration (F. Johansson, "Numerical integration in arbitrary-precision ball arithmetic",
/// 2018). The interval is split where functions of the contact change their formulas; on each
/// piece, the variable is chosen so that a root at an end is not singular (integrand.hpp). For a
/// principal value, the path passes the pole in the upper half-plane, where the integrand without
/// the pole is shown to be holomorphic, and half the residue is added. The pressure of a piecewise
/// linear slope is integrated above the contact, where it is analytic.
///
/// `digits`: the relative accuracy aimed at, which is not guaranteed: the width of the ball is the
/// result of a limited number of evaluations. The ball is not finite if the integrand has no bound,
/// or is singular at an end that is not proved to be a zero of the expression under the root.
/// Throws Error for a function without an enclosure, BudgetError if the bits do not separate
/// places.
[[nodiscard]] Ball enclosed_integral(const Expr& node, const IntegralSurroundings& around,
                                     unsigned digits);

/// True if an integral(f, s, lo, hi) is proved to diverge: next to an end f is asymptotically equal
/// to a constant, which is not zero, times a power of the distance that is not integrable.
[[nodiscard]] bool certainly_divergent(const Expr& node, const IntegralSurroundings& around);

/// True if a function of the contact, such as p, occurs: a call that is not built in.
[[nodiscard]] bool holds_function(const Expr& e);

/// True for |g1(x)|, whose formula depends on the piece as that of g1 does.
[[nodiscard]] bool is_size_of_slope(const Expr& e);

/// True if p occurs with an argument that contains the variable.
[[nodiscard]] bool holds_pressure(const Expr& e, const std::string& variable);

/// The degree of e in p(variable) if all other factors are entire functions of the variable: sums,
/// products, whole powers, exp, sin, cos. The variable may not occur in a divisor.
[[nodiscard]] std::optional<int> degree_in_pressure(const Expr& e, const std::string& variable);

/// Returns the argument of the first P1of or bof that contains the variable.
[[nodiscard]] std::optional<Expr> contact_argument(const Expr& e, const std::string& variable);

/// A value of the variable at which a function of the contact changes its formula.
struct IntegrandCut {
    Expr at;
    bool of_contacts; ///< for P1of and bof, whose argument is a contact's right edge
};
/// Returns the cuts, unordered, inside the interval or not.
[[nodiscard]] std::vector<IntegrandCut> integrand_cuts(const Expr& f, const std::string& variable,
                                                       const ContactFormulas& contact);

/// True if e is proved to vanish for all values of its names, wherever it is defined (algebra/).
/// False means that no proof was found.
[[nodiscard]] bool vanishes_where_defined(const Expr& e, EdgeLaw law);
/// The same, and e is defined where its parts are: for sums, products, quotients and integer powers
/// of names, numbers and functions of the contact only.
[[nodiscard]] bool surely_zero(const Expr& e, EdgeLaw law);

} // namespace edgeproof::audit
