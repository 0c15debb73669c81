// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/contact/profile/profile.hpp"
#include "edgeproof/formula/expr.hpp"
#include "edgeproof/precision/ball/ball.hpp"
#include "edgeproof/precision/ball/complex_box.hpp"
#include "edgeproof/precision/real.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace edgeproof::contact {

/// g' of a Profile (dimensionless; x is a length) in Real, at the precision of the thread that
/// constructs it.
class RealSlope {
public:
    struct Piece {
        bool linear = false;
        Real at_origin{}; ///< g' = at_origin + rate x if linear
        Real rate{};
        Expr expression;
    };

    explicit RealSlope(const Profile& profile);

    [[nodiscard]] const std::vector<Real>& knots() const noexcept { return knots_; }
    [[nodiscard]] const std::vector<Piece>& pieces() const noexcept { return pieces_; }
    [[nodiscard]] std::size_t origin() const noexcept { return origin_; }
    /// g'(x) by the expression of one piece.
    [[nodiscard]] Real value(std::size_t piece, const Real& x) const;
    /// g'' by the expression of one piece (1/length).
    [[nodiscard]] Real rate(std::size_t piece, const Real& x) const;
    /// The piece that contains x; at a knot, the one to its right.
    [[nodiscard]] std::size_t piece_at(const Real& x) const;

private:
    std::size_t origin_;
    std::vector<Real> knots_;
    std::vector<Piece> pieces_;
};

/// The first Taylor coefficients of g' over a box; not finite where g' may not be holomorphic.
[[nodiscard]] std::vector<Box> holomorphic_series(const Expr& slope, const Box& s,
                                                  std::size_t terms, long bits);

/// Returns a slope g'(x) as a function of the distance x - knot; the symbol of the distance is x
/// again. Parts that are linear in x and vanish at the knot lose their constant exactly. So (x -
/// 1/5)^(3/2) keeps its digits at any distance from 1/5.
[[nodiscard]] Expr slope_from_knot(const Expr& slope, const Expr& knot);

/// A slope near a knot that is a branch point of it, written without the branch point. With
/// w^root = |x - knot|, (x - knot)^(3/2) becomes w^3 for root = 2 (docs/curved-slopes.md, "What is
/// integrated").
struct SlopeAtRoot {
    Expr slope;    ///< as a function of w >= 0; the symbol is called x
    long root = 1; ///< the least common denominator of the exponents of x - knot
};

/// Returns this form for the side to the right or to the left of the knot. Returns nothing if no
/// power of a multiple of x - knot has a rational exponent that is not an integer, or if the common
/// denominator is greater than 24.
[[nodiscard]] std::optional<SlopeAtRoot> slope_at_root(const Expr& slope, const Expr& knot,
                                                       bool to_the_right);

/// Checks a profile given by the user: the knots ascend, g' does not decrease, g' <= 0 left of the
/// origin and g' >= 0 right of it. Returns which knots are corners. Throws an InputError that names
/// the place.
/// On a piece between two knots that is not linear, g' is only *sampled* here (64 points); the
/// contact proves that it rises for every value that is called proved (curved_slope.hpp).
/// Linear pieces and all knots are decided exactly. rising_limit checks the outer pieces.
[[nodiscard]] std::vector<bool> checked_corners(const Profile& profile);

/// The place where an outer piece stops rising.
struct RisingLimit {
    Exact at;      ///< the place, moved back by a millionth of its distance from the last knot
    Rational rate; ///< the rate of the straight line that continues g', > 0, 1/length
    Expr slope;    ///< the slope of the piece
};

/// Returns the place where the outermost piece on a side stops rising or stops having a value. The
/// piece is sampled at distances of 2^-30 to 2^30 from its knot. Returns nothing if neither
/// happens, or if the piece is linear. Throws InputError if it happens at the knot.
[[nodiscard]] std::optional<RisingLimit> rising_limit(const Profile& profile, Edge edge);

/// Throws InputError if the contact reaches a place beyond which the profile does not rise. `a` and
/// `b` are enclosures of the edges.
void check_reach(const Profile& profile, const Ball& a, const Ball& b);

} // namespace edgeproof::contact
