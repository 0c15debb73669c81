// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/law/kernels.hpp"
#include "edgeproof/contact/profile/profile.hpp"
#include "edgeproof/precision/real.hpp"

#include <cstddef>
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

} // namespace edgeproof::contact
