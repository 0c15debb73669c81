// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/enclosure/enclosed_sample.hpp"
#include "edgeproof/formula/expr.hpp"

namespace edgeproof::audit {

/// Two samples of a sweep, in balls; the second is nearer to its end.
struct SweptPair {
    const EnclosedSample& before;
    const EnclosedSample& after;
};

/// Returns the number of decades that a formula may hide: the ratios of the terms of its sums at
/// the first sample, the digits of its numbers, the distance of a place from its edge. A small term
/// may dominate only beyond this number of decades; therefore a formula is followed until it has
/// changed by more. Infinite if a name has no value.
[[nodiscard]] double hidden_decades(const formula::Expr& e, const SweptPair& at);

/// True if each sum of the formula (difference, maximum, minimum) has reached its final form: one
/// of the two terms dominates by a factor of at least 1000, and by more at the second sample than
/// at the first, or their ratio no longer changes. Otherwise the limit is not yet visible:
/// log(log(m)) - 9 is negative at m = 1e1000 and grows without bound. This test can only keep a
/// claim undecided.
[[nodiscard]] bool sums_are_steady(const formula::Expr& e, const SweptPair& at);

} // namespace edgeproof::audit
