// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/profile.hpp"

#include <vector>

namespace edgeproof {

/// Checks a user's own profile: knots ascend, g' does not decrease, g' <= 0 left of the origin
/// and >= 0 right of it. Returns which knots are corners. Throws InputError naming the place.
/// Convexity of an expression that is not linear is *sampled* (64 points a piece, and the ends);
/// that of linear pieces and of all knots is decided exactly.
[[nodiscard]] std::vector<bool> checked_corners(const Profile& profile);

} // namespace edgeproof
