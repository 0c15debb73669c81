// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/profile/profile.hpp"
#include "edgeproof/formula/expr.hpp"
#include "edgeproof/precision/ball/ball.hpp"
#include "edgeproof/precision/ball/complex_box.hpp"
#include "edgeproof/quadrature/theta_cells.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace edgeproof::contact {

/// An integrand over theta, s = c + d cos(theta) (docs/curved-slopes.md, "What is integrated").
/// Without x it is g'(s) cos(n theta). With x and a Taylor polynomial T_k of g' about x it is
/// (g'(s) - T_k(s))/(s - x)^(k+1): for k = 0 the quotient (g'(s) - g'(x))/(s - x), otherwise the
/// k-th derivative of this quotient by x, divided by k!.
struct SlopeIntegrand {
    const Expr* slope;   ///< in s
    const Expr* formula; ///< the same in the variable of the span
    Ball centre;         ///< c
    Ball half_length;    ///< d
    long harmonic = 0;   ///< n
    const Ball* x = nullptr;
    bool holds_x = false; ///< x is on this piece, so that the quotient has no pole
    const std::vector<Ball>* taylor = nullptr; ///< the k + 1 coefficients of T_k
    bool from_right_edge = false; ///< x is the right edge: s - x is computed without cancellation
    long goal = 0;                ///< accuracy wanted of the integral, in bits; 0: all bits
    /// With zeta the integrand is (g'(s) - mean)/(zeta - s)^poles instead.
    const Box* zeta = nullptr;
    const Ball* mean = nullptr;
    long poles = 1;
};

/// Returns an enclosure of the integral over a span by Arb's rigorous integration (johansson2018).
/// Arb integrates between the midpoints of the ends of the span; the radius of each end adds the
/// largest value of the integrand over that end.
/// @param f integrand
/// @param span range of theta
/// @param bits working precision
[[nodiscard]] Ball integrate(const SlopeIntegrand& f, const quadrature::ThetaSpan& span, long bits);
/// The same for an integrand with zeta.
[[nodiscard]] Box integrate_in_plane(const SlopeIntegrand& f, const quadrature::ThetaSpan& span,
                                     long bits);

/// Returns the Taylor series of g' about x with `terms` terms; each coefficient is an enclosure for
/// every point of the ball.
[[nodiscard]] std::vector<Ball> slope_series(const Expr& slope, const Ball& x, std::size_t terms,
                                             long bits);

/// The answer to the question whether g' increases from one edge to the other. The proofs of the
/// edges and of p > 0 need this.
struct SlopeMonotonicity {
    enum class Kind {
        rises, ///< proved: g' does not decrease anywhere
        falls, ///< proved: g' decreases at the given point
        open   ///< not decided
    };
    Kind kind = Kind::open;
    std::optional<Ball> where; ///< a point where g' decreases, or where no decision was possible
};

/// Decides whether g' is monotone over [-b, a], by the signs of g'' on cells that are bisected
/// (docs/curved-slopes.md, "The slope must be proved to rise"): in interval arithmetic
/// (moore-kearfott-cloud2009), or by the Taylor series at an end of a cell, for a g'' that is 0
/// there. Corners are not examined, because the constructor of the Profile has decided their signs
/// exactly. A wide ball only makes the contact longer. There is no decision if g'' touches 0
/// between two knots, unless this is visible as a square, or if g' contains a function that
/// complex_taylor.hpp does not support.
/// @param profile g'(x)
/// @param a,b distances of the edges from the origin (length)
[[nodiscard]] SlopeMonotonicity monotonicity_of_slope(const Profile& profile, const Ball& a,
                                                      const Ball& b);

} // namespace edgeproof::contact
