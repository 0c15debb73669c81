// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/enclosure/enclosed_sample.hpp"
#include "edgeproof/formula/expr.hpp"

namespace edgeproof::audit {

/// Two samples of a sweep, in balls, the second nearer to its end.
struct SweptPair {
    const EnclosedSample& before;
    const EnclosedSample& after;
};

/// How many decades a formula may hide: how far apart the terms of its sums are at the first
/// sample, the digits of its numbers, the distance of a place from its edge. A term that is as
/// small as that may prevail only as far away: a formula is followed until it has changed by more.
/// Infinite where a name has no value.
[[nodiscard]] double hidden_decades(const formula::Expr& e, const SweptPair& at);

/// Whether each sum of the formula (difference, maximum, minimum) has found its last form: of the
/// two terms one prevails by 1000 at least, and by more at the second sample than at the first, or
/// their ratio no longer changes. While it has not, the end is not in sight: log(log(m)) - 9 is
/// negative at m = 1e1000 and grows without bound. Only keeps a claim undecided.
[[nodiscard]] bool sums_are_steady(const formula::Expr& e, const SweptPair& at);

} // namespace edgeproof::audit
