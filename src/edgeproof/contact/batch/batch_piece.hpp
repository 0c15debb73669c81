// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/law/kernels.hpp"
#include "edgeproof/contact/profile/profile.hpp"
#include "edgeproof/contact/profile/slope.hpp"
#include "edgeproof/formula/evaluation/program.hpp"
#include "edgeproof/precision/ball/ball.hpp"
#include "edgeproof/precision/real.hpp"
#include "edgeproof/quadrature/holomorphic_reach.hpp"

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace edgeproof::contact {

/// The contact mapped to a half circle, which removes the singularities at the edges (as in
/// docs/curved-slopes.md, "What is integrated"): S = S_0 + h cos(phi), where phi is 0 at the right
/// end and pi at the left end. In general S = s, from -b to a. In a symmetric contact, whose two
/// halves are folded onto each other, S = s^2, from 0 to a^2. All computations use distances in S,
/// which are never obtained as differences of close numbers.
struct CircleMark {
    Real v;          ///< s at the mark (length)
    Real inset;      ///< a - s, at the precision of the contact (length)
    Real right;      ///< S from the mark to the right end
    Real left;       ///< S from the left end to the mark
    Real root_right; ///< sqrt(right)
    Real root_left;
};

struct BatchCircle {
    bool folded = false; ///< the contact is symmetric: S = s^2
    Real length;         ///< 2 h, the length of the range of S
    /// The left end, the knots inside, the right end.
    std::vector<CircleMark> marks;
    /// The pieces of g' between the marks.
    std::vector<std::size_t> pieces;
    /// The knot at each mark; not used at the ends.
    std::vector<std::size_t> knots;

    /// At the working precision of the thread; differences are taken at the precision of `e` where
    /// that is higher.
    /// @param profile g'(x)
    /// @param e distances of both edges from the origin (length)
    BatchCircle(const Profile& profile, const Extent<Real>& e);
};

/// Returns the angle in radians between two marks, or between a mark and a point.
/// @param length 2 h
/// @param left the one further to the left
/// @param right the other one
/// @param gap S between the two
[[nodiscard]] Real angle_between(const Real& length, const CircleMark& left,
                                 const CircleMark& right, const Real& gap);

/// Computes sin(x) and cos(x) to about one unit in the last place.
/// @param[out] sine sin(x)
/// @param[out] cosine cos(x)
/// @param x angle in radians, x >= 0
void sine_and_cosine(Real& sine, Real& cosine, const Real& x);

/// Returns x 2^(-exponent) as a binary64 number, for estimates.
[[nodiscard]] double in_units(const Real& x, long exponent);
/// Returns the binary exponent of x; 0 for x = 0.
[[nodiscard]] long exponent_of(const Real& x);

/// The nodes of one piece, with all quantities that do not depend on the point. G is g' without the
/// jumps at corners, multiplied by s in a folded contact; it does not decrease.
struct BatchNodes {
    std::vector<Real> weight;  ///< of d phi
    std::vector<Real> from_lo; ///< S from the left end of the piece
    std::vector<Real> from_hi; ///< S to its right end
    std::vector<Real> rise_lo; ///< G minus its value at the left end; empty if G is constant
    std::vector<Real> rise_hi; ///< G at the right end minus G
    std::vector<Real> lift_lo; ///< rise_lo times weight
    std::vector<Real> lift_hi; ///< rise_hi times weight
    std::vector<Real> s;       ///< s at the node; only in a folded contact
};

/// g' on a piece where it is not linear, computed in Arb's arithmetic.
class CurvedSlope {
public:
    /// `slopes` must live longer than this object.
    /// @param slopes g' of the profile
    /// @param piece index of the piece
    /// @param corners the part of g' due to corners to the left of the piece
    /// @param folded the contact is symmetric: G = s g'
    /// @param bits precision
    CurvedSlope(const SlopeIn<Real>& slopes, std::size_t piece, const Ball& corners, bool folded,
                long bits);
    /// Returns an enclosure of G(s) at s (length).
    [[nodiscard]] Ball G(const Ball& s) const;
    /// Returns (g'(s) - g'(v))/(s - v) without cancellation; `delta` is s - v (lengths).
    [[nodiscard]] Real quotient(const Real& v, const Real& s, const Real& delta) const;
    [[nodiscard]] const Expr& slope() const { return slope_; }
    [[nodiscard]] const Ball& corners() const { return corners_; }

private:
    const SlopeIn<Real>* slopes_;
    std::size_t piece_;
    Expr slope_;
    formula::Program program_;
    std::vector<Ball> constants_;
    Ball corners_;
    bool folded_;
};

/// One piece of g' between two marks. Its nodes are computed when they are first needed.
class BatchPiece {
public:
    /// @param circle the mapped contact
    /// @param index index of the mark at the left end of the piece
    /// @param alpha,beta g' without corners is alpha + beta s, if linear
    /// @param curved g' on the piece, if not linear; else null
    /// @param odd g' - g'(0) is proved to be odd
    BatchPiece(const BatchCircle& circle, std::size_t index, Real alpha, Real beta,
               std::unique_ptr<CurvedSlope> curved, bool odd);
    /// Computes the sizes in binary64 for estimates. S and G are measured in units of 2^S_exponent
    /// and 2^G_exponent.
    void measure(long S_exponent, long G_exponent);
    /// Finds an ellipse about the piece in which a curved G is holomorphic and bounded (in units of
    /// 2^G_exponent).
    /// @param G_exponent binary exponent of the unit of G
    /// @param ln_tolerance ln of the relative accuracy wanted
    void find_reach(long G_exponent, double ln_tolerance);

    /// Returns the Gauss-Legendre nodes: `n` nodes on the piece. If the piece ends at an edge of
    /// the contact where the integrand is even, these are half of the nodes of a rule over the
    /// piece and its mirror image.
    [[nodiscard]] const BatchNodes& gauss(std::size_t n) const;
    /// The size of the rule that has `n` nodes on the piece.
    [[nodiscard]] std::size_t rule_size(std::size_t n) const { return doubled ? 2 * n : n; }
    /// Returns the tanh-sinh nodes that a level adds.
    [[nodiscard]] const BatchNodes& level(int level) const;

    /// True if g' is linear on the piece.
    [[nodiscard]] bool linear() const { return !curved; }
    /// Returns G(x) minus G at the left end, for x in the piece or near it; `step` is x minus the
    /// left end (lengths).
    [[nodiscard]] Real rise_from_lo(const Real& x, const Real& step) const;
    /// Returns G at the right end minus G(x); `step` is the right end minus x (lengths).
    [[nodiscard]] Real rise_to_hi(const Real& x, const Real& step) const;

    /// True if height + rise is best written as (beta gap + rise) + (height - beta gap): the first
    /// part is a multiple of the denominator, and the second is a non-negative constant.
    /// @param gap S from the point to the near end of the piece
    /// @param height G from the point to the near end of the piece
    [[nodiscard]] bool constant_height(const Real& gap, const Real& height) const {
        return flat || (linear() && !folded && height >= beta * gap);
    }
    /// Returns a bound of |G - G(end)| over an ellipse about the piece, in units of 2^G_exponent.
    [[nodiscard]] double largest_rise(const quadrature::BernsteinEllipse& ellipse) const;

    bool folded;
    bool flat; ///< G is constant
    bool at_left_edge;
    bool at_right_edge;
    bool even_left; ///< the integrand is even at the left edge
    bool doubled;   ///< the rule covers the piece and its mirror image
    Real alpha;
    Real beta;
    std::unique_ptr<CurvedSlope> curved;
    const CircleMark* lo;
    const CircleMark* hi;
    Real angle;  ///< length of the piece in phi
    Real phi_hi; ///< phi at the right end of the piece
    Real span;   ///< length of the piece in S
    Real width;  ///< length of the piece in s
    Real rise;   ///< G at the right end minus G at the left end
    std::optional<quadrature::HolomorphicReach> reach;
    double angle_double = 0;
    double phi_right = 0; ///< phi_hi
    double span_units = 0;
    double rise_units = 0;
    double alpha_units = 0; ///< |alpha| times half the length of the contact
    double beta_units = 0;  ///< beta in units of G per S

    /// Returns G(x) - G_v, where G_v = G(v) and x = v + step (lengths).
    [[nodiscard]] Real curved_rise(const Real& v, const Ball& G_v, const Real& x,
                                   const Real& step) const;

private:
    /// Adds a node given by its angles from both ends of the piece (radians).
    void add(BatchNodes& nodes, const Real& from_hi, const Real& from_lo, const Real& weight) const;
    Real circle_length_;
    Real sine_hi_;
    Real cosine_hi_;
    Real sine_lo_;
    Real cosine_lo_; ///< cos(pi - phi) at the left end
    Ball G_lo_;
    Ball G_hi_;
    double length_units_ = 0;
    mutable std::map<std::size_t, BatchNodes> gauss_;
    mutable std::map<int, BatchNodes> levels_;
};

} // namespace edgeproof::contact
