// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/contact/profile/profile.hpp"
#include "edgeproof/formula/expr.hpp"
#include "edgeproof/precision/ball/ball.hpp"
#include "edgeproof/precision/ball/complex_box.hpp"
#include "edgeproof/quadrature/theta_cells.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace edgeproof::contact {

/// g' on a span of theta, s = c + d cos(theta), and what is integrated of it
/// (docs/curved-slopes.md, "What is integrated"). The integrands are functions of the variable t of
/// the span and of s: over a box of t that is not real they are holomorphic where they are finite;
/// over a real one they enclose the values.
struct SlopeOnSpan {
    const Expr& slope;   ///< in s
    const Expr& formula; ///< the same in the variable of the span
    quadrature::ThetaSpan span;
    Ball centre;      ///< c
    Ball half_length; ///< d

    using Integrand = std::function<Box(const SlopeOnSpan& on, const Box& t, const Box& s)>;
    /// Returns the enclosed integral of f over theta to `accuracy` bits.
    [[nodiscard]] Box integral(const Integrand& f, long accuracy, long bits) const;

    /// g'.
    [[nodiscard]] Box value(const Box& t, const Box& s) const;
    /// cos(n theta).
    [[nodiscard]] Box cosine(long n, const Box& t, const Box& s) const;
    /// (g'(s) - T(s))/(s - x)^n with the Taylor polynomial T of g' about x, of n terms: for n = 1
    /// the quotient (g'(s) - g'(x))/(s - x), otherwise the (n-1)-th derivative of this quotient by
    /// x, divided by (n-1)!. `holds_x`: x is on this piece, so that the quotient has no pole;
    /// `from_right_edge`: x is the right edge.
    [[nodiscard]] Box quotient(const Ball& x, const std::vector<Ball>& taylor, bool holds_x,
                               bool from_right_edge, const Box& t, const Box& s) const;
    /// (g'(s) - mean)/(zeta - s)^poles.
    [[nodiscard]] Box over_distance(const Box& zeta, const Ball& mean, std::size_t poles,
                                    const Box& t, const Box& s) const;
};

/// The precision of what is proved of a slope, whatever that of the contact is.
constexpr long slope_bits = 128;

/// Returns the Taylor series of g' about x with `terms` terms; each coefficient is an enclosure for
/// every point of the ball.
[[nodiscard]] std::vector<Ball> slope_series(const Expr& slope, const Ball& x, std::size_t terms,
                                             long bits);

/// g' over a box of places: holomorphic where it is finite and the box is not real.
[[nodiscard]] Box slope_over(const Expr& slope, const Box& s);

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
/// (docs/curved-slopes.md, "The slope must be proved to rise") by Taylor series over a cell, and at
/// an end of it for a g'' that is 0 there. Corners are not examined, because the constructor of the
/// Profile has decided their signs exactly. A wide ball only makes the contact longer. There is no
/// decision if g'' touches 0 between two knots, unless this is visible at a rational z as in
/// (x - z)^3, or if g' contains a function that complex_taylor.hpp does not support.
/// @param profile g'(x)
/// @param a,b distances of the edges from the origin (length)
[[nodiscard]] SlopeMonotonicity monotonicity_of_slope(const Profile& profile, const Ball& a,
                                                      const Ball& b);

/// An upper bound of g'' over [-b, a]; not finite if there is none, as with a corner.
[[nodiscard]] Ball steepest_rise(const Profile& profile, const Ball& a, const Ball& b);

/// True if the greatest pressure of a symmetric profile, plane or of revolution, is proved to be in
/// the middle: it has no corner, and g'' does not increase too fast from there
/// (docs/curved-slopes.md, "The greatest pressure").
[[nodiscard]] bool greatest_in_the_middle(const Profile& profile, const Ball& a);

} // namespace edgeproof::contact
