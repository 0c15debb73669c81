// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/profile/profile.hpp"
#include "edgeproof/contact/profile/slope.hpp"
#include "edgeproof/precision/ball/ball.hpp"

#include <optional>
#include <vector>

namespace edgeproof::contact {

/// Checks a user's own profile: knots ascend, g' does not decrease, g' <= 0 left of the origin
/// and >= 0 right of it. Returns which knots are corners. Throws InputError naming the place.
/// Convexity of a piece between two knots that is not linear is *sampled* here (64 points), and
/// proved in the contact for every value that is called proved (slope_monotonicity.hpp); that of
/// linear pieces and of all knots is decided exactly. Of an outer piece, see rising_limit.
[[nodiscard]] std::vector<bool> checked_corners(const Profile& profile);

/// Where an outer piece ends to rise.
struct RisingLimit {
    formula::Exact at;   ///< a millionth of the way from the last knot short of it
    Rational rate;       ///< some rate to go on with, > 0
    formula::Expr slope; ///< of the piece
};

/// Where the outermost piece on a side, looked at over 2^-30 ... 2^30 from its knot, ends to rise
/// or to have a value; nothing where it does neither, or is linear. Throws InputError where it does
/// so at its knot.
[[nodiscard]] std::optional<RisingLimit> rising_limit(const Profile& profile, Edge edge);

/// Throws InputError for a contact that reaches a place beyond which the profile does not rise; its
/// edges as enclosures.
void check_reach(const Profile& profile, const Ball& a, const Ball& b);

/// Throws InputError where one of 64 samples of a piece inside the contact shows g' decrease.
void sample_slope(const Profile& profile, const SlopeIn<Real>& slope, const Real& a, const Real& b);

} // namespace edgeproof::contact
