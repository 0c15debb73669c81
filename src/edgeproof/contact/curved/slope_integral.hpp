// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/formula/expr.hpp"
#include "edgeproof/precision/ball/ball.hpp"
#include "edgeproof/quadrature/theta_cells.hpp"

#include <cstddef>
#include <vector>

namespace edgeproof::contact {

/// What is integrated over theta, s = c + d cos theta: g'(s) cos(n theta), or with x given
/// (g'(s) - g'(x))/(s - x), or with a Taylor polynomial T_k of g' about x given
/// (g'(s) - T_k(s))/(s - x)^(k+1): what the former's k-th derivative in x comes to, over k!.
struct SlopeIntegrand {
    const formula::Expr* slope;   ///< in s
    const formula::Expr* formula; ///< the same in the variable of the span
    Ball centre;
    Ball half_length;
    long harmonic = 0;
    const Ball* x = nullptr;
    const Ball* slope_at_x = nullptr;
    bool holds_x = false; ///< g' is this piece's at x too, so that the quotient has no pole
    const std::vector<Ball>* taylor = nullptr; ///< its k + 1 coefficients
    bool from_right_edge = false;              ///< x is the right edge: s - x without cancellation
    long goal = 0; ///< bits of the integral that are worth their work; 0: all
};

/// The integral over a span, enclosed by Arb's rigorous integration: F. Johansson, "Numerical
/// integration in arbitrary-precision ball arithmetic" (2018). Between the middles of its ends by
/// Arb, and what their radii leave by the largest value of the integrand over them.
[[nodiscard]] Ball integrate(const SlopeIntegrand& f, const quadrature::ThetaSpan& span, long bits);

/// The Taylor series of g' about x, `terms` terms, each an enclosure for every point of the ball.
[[nodiscard]] std::vector<Ball> slope_series(const formula::Expr& slope, const Ball& x,
                                             std::size_t terms, long bits);

} // namespace edgeproof::contact
