// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/formula/expr.hpp"

#include <optional>

namespace edgeproof::contact {

/// A slope beside a knot that is a branch point of it, without the branch point: |x - knot| =
/// w^root makes (x - knot)^(3/2) the cube of w for root = 2.
struct SlopeAtRoot {
    formula::Expr slope; ///< in w >= 0, called x
    long root = 1;       ///< least common denominator of the powers of x - knot
};

/// On the side of the knot to its right or its left. Nothing where no power of a multiple of
/// x - knot has a rational exponent that is not whole, or where their denominators have too large a
/// common multiple.
[[nodiscard]] std::optional<SlopeAtRoot>
slope_at_root(const formula::Expr& slope, const formula::Expr& knot, bool to_the_right);

} // namespace edgeproof::contact
