// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/profile/profile.hpp"
#include "edgeproof/precision/ball/ball.hpp"

#include <optional>

namespace edgeproof::contact {

/// Whether g' rises from one edge to the other: what a contact is incomplete by, and what the
/// proofs of its edges and of p > 0 rest on.
struct SlopeMonotonicity {
    enum class Kind {
        rises, ///< proved: g' decreases nowhere
        falls, ///< proved: g' decreases at the point named
        open   ///< not decided
    };
    Kind kind = Kind::open;
    std::optional<Ball> where; ///< a point where g' falls, or where nothing was decided
};

/// Whether g' is monotone over [-b, a], by the signs of g'' on cells that are halved: in interval
/// arithmetic, or by the Taylor series at a cell's end, which decides where g'' touches 0 there.
/// Corners are not looked at: the maker of the Profile has decided their signs exactly. Balls that
/// are wide only make the contact longer. Never decided where g'' touches 0 between two knots in
/// a way that no square shows, or where a function in g' is one that complex_taylor.hpp does not
/// know.
[[nodiscard]] SlopeMonotonicity monotonicity_of_slope(const Profile& profile, const Ball& a,
                                                      const Ball& b);

} // namespace edgeproof::contact
