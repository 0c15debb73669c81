// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/enclosure/contact_formulas.hpp"
#include "edgeproof/formula/expr.hpp"
#include "edgeproof/precision/ball/ball.hpp"

#include <functional>
#include <optional>

namespace edgeproof::audit {

/// The context of an integral.
struct IntegralSurroundings {
    /// Returns the value of a formula without the variable of the integral and without names of
    /// ContactFormulas.
    std::function<Ball(const formula::Expr&)> value;
    /// Returns that value if it is a rational number.
    std::function<std::optional<Rational>(const formula::Expr&)> rational;
    const ContactFormulas* contact = nullptr; ///< needed for functions of the contact
    bool symmetric = false;                   ///< b(s) = s
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
[[nodiscard]] Ball enclosed_integral(const formula::Expr& node, const IntegralSurroundings& around,
                                     unsigned digits);

} // namespace edgeproof::audit
