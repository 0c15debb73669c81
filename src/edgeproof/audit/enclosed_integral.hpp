// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/formula/expr.hpp"
#include "edgeproof/precision/ball.hpp"

#include <functional>
#include <string_view>

namespace edgeproof {

/// What a name in an integrand stands for: a real number, enclosed.
using NameEnclosure = std::function<Ball(std::string_view)>;

/// The integral of a formula in `variable` from lo to hi, by Arb's rigorous integration (F.
/// Johansson, "Numerical integration in arbitrary-precision ball arithmetic", 2018): the integrand
/// is enclosed on boxes of the complex plane, which must not hold a pole; square roots may branch
/// at an end point. `digits`: the relative accuracy aimed at, not promised: the ball is as wide as
/// it comes out after a counted number of evaluations. Not finite where the integrand has no bound.
/// Throws Error for a function that has no enclosure there (those of a Setting, abs, max, min).
[[nodiscard]] Ball enclosed_integral(const Expr& integrand, std::string_view variable,
                                     const NameEnclosure& names, const Ball& lo, const Ball& hi,
                                     unsigned digits);

} // namespace edgeproof
