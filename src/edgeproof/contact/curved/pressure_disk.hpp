// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/formula/expr.hpp"
#include "edgeproof/precision/ball/ball.hpp"
#include "edgeproof/precision/ball/ball_series.hpp"
#include "edgeproof/precision/ball/magnitude.hpp"
#include "edgeproof/quadrature/theta_cells.hpp"

#include <cstddef>
#include <vector>

namespace edgeproof::contact {

/// What the integral I(x) of (g'(s) - g'(x))/(s - x) over theta is taken of. p = E*/(2 pi) w(x)
/// I(x) (eqn:SIEPressure, the principal value of 1/(s - x) being none).
struct SlopeOverTheta {
    std::vector<formula::Expr> formulas; ///< of the pieces in s, and of spans with a root
    std::vector<quadrature::ThetaSpan> spans;
    std::vector<quadrature::ThetaSpan> pieces; ///< the same without roots
    Ball centre;
    Ball half_length;
    Magnitude most_change; ///< of g' from one edge to the other: g' does not decrease
};

/// Bits to which the coefficients of a disk are driven, of the working ones: enough beside a
/// tolerance for which the search in ball_extent.hpp takes so many.
[[nodiscard]] constexpr long disk_goal(long bits) { return bits < 96 ? 24 : bits / 2 - 24; }

/// I(x + z) in powers of z: coefficients, and a disk on which it is holomorphic and bounded, whence
/// Cauchy's bound for all those that are left out. It is holomorphic where the formula of the piece
/// that holds x is and no other piece is met, beyond an edge too.
class PressureDisk {
public:
    /// About x, on the piece `holds`, whose nearest other piece inside the contact is at least as
    /// far as `gap`. `bits`: of the working arithmetic.
    PressureDisk(const SlopeOverTheta& integral, std::size_t holds, const Ball& x, const Ball& gap,
                 std::size_t terms, long bits);

    /// False where no disk, or no integral, was enclosed.
    [[nodiscard]] bool found() const { return found_; }
    [[nodiscard]] std::size_t terms() const { return terms_; }
    [[nodiscard]] const Ball& radius() const { return radius_; }
    /// |I| <= bound on the disk.
    [[nodiscard]] Ball bound() const { return bound_.ball(64); }
    /// I(x + z + t) in powers of t, for every z of the ball; not finite where it reaches too far.
    [[nodiscard]] BallSeries at(const Ball& z, std::size_t order) const;
    /// Whether what is left out of I(x + z) is below 2^-bits of the bound.
    [[nodiscard]] bool good_to(const Ball& z, long bits) const;

private:
    std::vector<Ball> coefficients_;
    Ball radius_;
    Magnitude bound_;
    std::size_t terms_;
    long bits_;
    bool found_ = false;
};

/// I(x) for every x of a ball that is on a piece, or may be on its end, by the pieces beyond
/// `inner` of theta left out: an enclosure. Not finite where none is found.
[[nodiscard]] Ball outer_integral(const SlopeOverTheta& integral,
                                  const std::vector<quadrature::ThetaSpan>& outer,
                                  std::size_t holds, const Ball& x, long bits);

} // namespace edgeproof::contact
