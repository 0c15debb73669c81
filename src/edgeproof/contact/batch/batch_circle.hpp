// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/law/kernels.hpp"
#include "edgeproof/contact/profile/profile.hpp"
#include "edgeproof/precision/real.hpp"

#include <cstddef>
#include <vector>

namespace edgeproof::contact {

/// The contact bent over a half circle, where its edges are no singularities: S = S_0 + h cos(phi),
/// phi from 0 at the right end to pi at the left. S is s itself, from -b to a; of a symmetric
/// contact, whose halves are laid on each other, S = s^2, from 0 to a^2. All that a point has to do
/// with happens through distances in S, which are never differences of near numbers.
struct CircleMark {
    Real v;          ///< s there
    Real inset;      ///< a - s, at the precision that the contact was given with
    Real right;      ///< S from here to the right end
    Real left;       ///< S from the left end to here
    Real root_right; ///< sqrt(right)
    Real root_left;
};

struct BatchCircle {
    bool folded = false; ///< symmetric: S = s^2
    Real length;         ///< 2 h, from end to end in S
    /// The left end, the knots inside, the right end.
    std::vector<CircleMark> marks;
    /// The pieces of g' between them.
    std::vector<std::size_t> pieces;
    /// For each mark the knot that it is; no meaning at the ends.
    std::vector<std::size_t> knots;

    /// At the thread's working precision, the differences at that of `e` where it is higher.
    BatchCircle(const Profile& profile, const Extent<Real>& e);
};

/// The angle between two marks, or a mark and a point: both ends by their distances; the first
/// further left, `gap` apart.
[[nodiscard]] Real angle_between(const Real& length, const CircleMark& left,
                                 const CircleMark& right, const Real& gap);

/// sin and cos of x >= 0, to about an ulp of themselves.
void sine_and_cosine(Real& sine, Real& cosine, const Real& x);

/// x in units of 2^exponent, for estimates.
[[nodiscard]] double in_units(const Real& x, long exponent);
[[nodiscard]] long exponent_of(const Real& x);

} // namespace edgeproof::contact
