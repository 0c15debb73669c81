// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/profile/profile.hpp"
#include "edgeproof/precision/ball/ball.hpp"

#include <optional>

namespace edgeproof::contact {

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
