// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/profile/profile.hpp"
#include "edgeproof/contact/profile/slope.hpp"
#include "edgeproof/precision/ball/ball.hpp"

#include <optional>
#include <vector>

namespace edgeproof::contact {

/// Checks a profile given by the user: the knots ascend, g' does not decrease, g' <= 0 left of the
/// origin and g' >= 0 right of it. Returns which knots are corners. Throws an InputError that names
/// the place.
/// On a piece between two knots that is not linear, g' is only *sampled* here (64 points); the
/// contact proves that it rises for every value that is called proved (slope_monotonicity.hpp).
/// Linear pieces and all knots are decided exactly. rising_limit checks the outer pieces.
[[nodiscard]] std::vector<bool> checked_corners(const Profile& profile);

/// The place where an outer piece stops rising.
struct RisingLimit {
    formula::Exact at; ///< the place, moved back by a millionth of its distance from the last knot
    Rational rate;     ///< the rate of the straight line that continues g', > 0, 1/length
    formula::Expr slope; ///< the slope of the piece
};

/// Returns the place where the outermost piece on a side stops rising or stops having a value. The
/// piece is sampled at distances of 2^-30 to 2^30 from its knot. Returns nothing if neither
/// happens, or if the piece is linear. Throws InputError if it happens at the knot.
[[nodiscard]] std::optional<RisingLimit> rising_limit(const Profile& profile, Edge edge);

/// Throws InputError if the contact reaches a place beyond which the profile does not rise. `a` and
/// `b` are enclosures of the edges.
void check_reach(const Profile& profile, const Ball& a, const Ball& b);

/// Throws InputError if 64 samples of a piece inside the contact -b < x < a show that g' decreases.
void sample_slope(const Profile& profile, const SlopeIn<Real>& slope, const Real& a, const Real& b);

} // namespace edgeproof::contact
