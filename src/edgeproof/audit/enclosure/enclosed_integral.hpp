// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/enclosure/contact_formulas.hpp"
#include "edgeproof/formula/expr.hpp"
#include "edgeproof/precision/ball/ball.hpp"

#include <functional>
#include <optional>

namespace edgeproof::audit {

/// What stands around an integral.
struct IntegralSurroundings {
    /// A formula without the variable of the integral, and without names of ContactFormulas.
    std::function<Ball(const formula::Expr&)> value;
    /// The same, if it is a rational number.
    std::function<std::optional<Rational>(const formula::Expr&)> rational;
    const ContactFormulas* contact = nullptr; ///< functions of the contact have no meaning without
    bool symmetric = false;                   ///< b(s) = s
    long bits = 0;
};

/// The value of an integral(f, s, lo, hi) or pv(f, s, lo, hi, x), by Arb's rigorous integration (F.
/// Johansson, "Numerical integration in arbitrary-precision ball arithmetic", 2018): split where
/// functions of the contact change their formulas, and on each piece in a variable in which a root
/// at an end is none (integrand.hpp). A principal value goes over the pole in the upper half-plane,
/// where the integrand without the pole is shown to be holomorphic, and has half the residue added.
/// The pressure of a piecewise linear slope is integrated above the contact, where it is analytic.
///
/// `digits`: the relative accuracy aimed at, not promised: the ball is as wide as it comes out
/// after a counted number of evaluations. Not finite where the integrand has no bound, or is
/// singular at an end that is not proved to be the zero of what is under the root. Throws Error for
/// a function that has no enclosure there, BudgetError where the bits do not tell places apart.
[[nodiscard]] Ball enclosed_integral(const formula::Expr& node, const IntegralSurroundings& around,
                                     unsigned digits);

} // namespace edgeproof::audit
