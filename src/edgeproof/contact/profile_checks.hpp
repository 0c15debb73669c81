// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/profile.hpp"

#include <vector>

namespace edgeproof {

/// Checks a user's own profile: knots ascend, g' does not decrease, g' <= 0 left of the origin
/// and >= 0 right of it. Returns which knots are corners. Throws InputError naming the place.
/// Convexity of an expression that is not linear is *sampled* here (64 points a piece, and the
/// ends), and proved in the contact for every value that is called proved (rising_slope.hpp); that
/// of linear pieces and of all knots is decided exactly.
[[nodiscard]] std::vector<bool> checked_corners(const Profile& profile);

} // namespace edgeproof
