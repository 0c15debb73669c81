// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/batch/batch_circle.hpp"
#include "edgeproof/contact/profile/slope.hpp"
#include "edgeproof/formula/evaluation/program.hpp"
#include "edgeproof/precision/ball/ball.hpp"
#include "edgeproof/quadrature/holomorphic_reach.hpp"

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace edgeproof::contact {

/// Nodes of one piece: all that does not depend on the point. G is g' with its corners taken out,
/// times s where the contact is folded; it does not decrease.
struct BatchNodes {
    std::vector<Real> weight;  ///< d phi
    std::vector<Real> from_lo; ///< S from the left end of the piece
    std::vector<Real> from_hi; ///< S to its right end
    std::vector<Real> rise_lo; ///< G less its value at the left end; empty where G is constant
    std::vector<Real> rise_hi; ///< G at the right end less its value
    std::vector<Real> lift_lo; ///< rise times weight
    std::vector<Real> lift_hi;
    std::vector<Real> s; ///< of a folded contact
};

/// g' on a piece where it is not linear, run in Arb's arithmetic.
class CurvedSlope {
public:
    /// `corners`: what the corners left of the piece have added to g'. `slopes` must outlive it.
    CurvedSlope(const SlopeIn<Real>& slopes, std::size_t piece, const Ball& corners, bool folded,
                long bits);
    [[nodiscard]] Ball G(const Ball& s) const;
    /// (g'(s) - g'(v))/(s - v), without cancellation.
    [[nodiscard]] Real quotient(const Real& v, const Real& s, const Real& delta) const;
    [[nodiscard]] const formula::Expr& slope() const { return slope_; }
    [[nodiscard]] const Ball& corners() const { return corners_; }

private:
    const SlopeIn<Real>* slopes_;
    std::size_t piece_;
    formula::Expr slope_;
    formula::Program program_;
    std::vector<Ball> constants_;
    Ball corners_;
    bool folded_;
};

/// One piece of g' between two marks, and its nodes as they are asked for.
class BatchPiece {
public:
    /// g' = alpha + beta s, corners taken out, or `curved`.
    BatchPiece(const BatchCircle& circle, std::size_t index, Real alpha, Real beta,
               std::unique_ptr<CurvedSlope> curved, bool odd);
    /// Its sizes in binary64, for estimates: S and G in units of two to these powers.
    void measure(long S_exponent, long G_exponent);
    /// Where G is curved: how far around the piece it is holomorphic (its bound in those units).
    void find_reach(long G_exponent, double ln_tolerance);

    /// Gauss-Legendre: `n` nodes over the piece; where it ends at an edge of the contact, in which
    /// the integrand is even, half of a rule over the piece and its mirror image.
    [[nodiscard]] const BatchNodes& gauss(std::size_t n) const;
    /// Of how many nodes over which half-length `n` nodes are.
    [[nodiscard]] std::size_t rule_size(std::size_t n) const { return doubled ? 2 * n : n; }
    /// Tanh-sinh: the nodes that a level adds.
    [[nodiscard]] const BatchNodes& level(int level) const;

    [[nodiscard]] bool linear() const { return !curved; }
    /// G at x less G at the left end, for x in the piece or near it.
    [[nodiscard]] Real rise_from_lo(const Real& x, const Real& step) const;
    /// G at the right end less G at x; `step` is from x to the end, negative beyond it.
    [[nodiscard]] Real rise_to_hi(const Real& x, const Real& step) const;

    /// Whether height + rise over the piece is best taken apart into beta gap + rise, which is a
    /// multiple of the denominator, and a constant that is not negative.
    [[nodiscard]] bool constant_height(const Real& gap, const Real& height) const {
        return flat || (linear() && !folded && height >= beta * gap);
    }
    /// A bound of |G - G(end)| over an ellipse about the piece, in units of G.
    [[nodiscard]] double largest_rise(const quadrature::BernsteinEllipse& ellipse) const;

    bool folded;
    bool flat; ///< G is constant
    bool at_left_edge;
    bool at_right_edge;
    bool even_left; ///< at the left edge, in which the integrand is even
    bool doubled;
    Real alpha;
    Real beta;
    std::unique_ptr<CurvedSlope> curved;
    const CircleMark* lo;
    const CircleMark* hi;
    Real angle;  ///< the length in phi
    Real phi_hi; ///< of its right end, from the right end of the circle
    Real span;   ///< in S
    Real width;  ///< in s
    Real rise;   ///< of G over the piece
    std::optional<quadrature::HolomorphicReach> reach;
    double angle_double = 0;
    double phi_right = 0; ///< phi_hi
    double span_units = 0;
    double rise_units = 0;
    double alpha_units = 0; ///< |alpha| times the half-width of the contact
    double beta_units = 0;  ///< G per S

    [[nodiscard]] Real curved_rise(const Real& v, const Ball& G_v, const Real& x,
                                   const Real& step) const;

private:
    void add(BatchNodes& nodes, const Real& from_hi, const Real& from_lo, const Real& weight) const;
    Real circle_length_;
    Real sine_hi_;
    Real cosine_hi_;
    Real sine_lo_;
    Real cosine_lo_; ///< of pi - phi at the left end
    Ball G_lo_;
    Ball G_hi_;
    double length_units_ = 0;
    mutable std::map<std::size_t, BatchNodes> gauss_;
    mutable std::map<int, BatchNodes> levels_;
};

} // namespace edgeproof::contact
