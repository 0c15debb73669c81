// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/contact/profile/edge.hpp"
#include "edgeproof/precision/ball/ball.hpp"
#include "edgeproof/precision/ball/ball_series.hpp"
#include "edgeproof/precision/ball/complex_box.hpp"
#include "edgeproof/precision/ball/magnitude.hpp"
#include "edgeproof/quadrature/theta_cells.hpp"

#include <cstddef>
#include <vector>

namespace edgeproof::contact {

/// The data of I(x), the integral of (g'(s) - g'(x))/(s - x) over theta: p = E*/(2 pi) w(x) I(x)
/// (eqn:SIEPressure regularised; docs/curved-slopes.md, "What is integrated").
struct SlopeOverTheta {
    std::vector<Expr> formulas; ///< of the pieces in s, and of the spans with a root
    std::vector<quadrature::ThetaSpan> spans;
    std::vector<quadrature::ThetaSpan> pieces; ///< the same without roots
    Ball centre;
    Ball half_length;
    Magnitude most_change; ///< of g' from one edge to the other
};

/// The number of bits to which the coefficients of a disk are computed at a working precision of
/// `bits`. They suffice for the tolerances for which the search in ball_extent.hpp uses that
/// precision.
[[nodiscard]] constexpr long disk_goal(long bits) { return bits < 96 ? 24 : bits / 2 - 24; }

/// The power series of I(x + z) in z: coefficients, and a disk on which I is holomorphic and
/// bounded, so that Cauchy's estimate bounds the remainder (docs/curved-slopes.md, "Intervals and
/// disks"). I is holomorphic where the formula of the piece that contains x is, up to the next
/// piece; the disk may extend beyond an edge.
class PressureDisk {
public:
    /// A disk about x.
    /// @param integral the data of I
    /// @param holds the piece that contains x
    /// @param x centre (length)
    /// @param gap lower bound of the distance from x to the next other piece inside the contact
    /// (length)
    /// @param terms number of coefficients
    /// @param bits working precision
    PressureDisk(const SlopeOverTheta& integral, std::size_t holds, const Ball& x, const Ball& gap,
                 std::size_t terms, long bits);

    /// False if no disk or no integral was enclosed.
    [[nodiscard]] bool found() const { return found_; }
    [[nodiscard]] std::size_t terms() const { return terms_; }
    [[nodiscard]] const Ball& radius() const { return radius_; }
    /// A bound of |I| on the disk (1/length).
    [[nodiscard]] Ball bound() const { return bound_.ball(64); }
    /// Returns I(x + z + t) in powers of t, for every z of the ball, or of the box (length); not
    /// finite if it reaches too far.
    [[nodiscard]] BallSeries at(const Ball& z, std::size_t order) const;
    [[nodiscard]] std::vector<Box> at(const Box& z, std::size_t order) const;
    /// True if the remainder of I(x + z) is below 2^-bits times the bound.
    [[nodiscard]] bool good_to(const Ball& z, long bits) const;

private:
    std::vector<Ball> coefficients_;
    Ball radius_;
    Magnitude bound_;
    std::size_t terms_;
    long bits_;
    bool found_ = false;
};

/// Returns an enclosure of the integral of (g'(s) - g'(x))/(s - x) over the spans `outer` of theta,
/// for every x of a ball that lies on a piece, perhaps at its end. Not finite if none is found.
/// @param integral the data of I
/// @param outer spans of theta
/// @param holds the piece that contains x
/// @param x ball (length)
/// @param bits working precision
[[nodiscard]] Ball outer_integral(const SlopeOverTheta& integral,
                                  const std::vector<quadrature::ThetaSpan>& outer,
                                  std::size_t holds, const Ball& x, long bits);

} // namespace edgeproof::contact
