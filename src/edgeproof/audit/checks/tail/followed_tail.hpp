// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/checks/parts/parameter_sweep.hpp"
#include "edgeproof/audit/ledger/judgement.hpp"
#include "edgeproof/formula/expr.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace edgeproof::audit {

/// A claimed limit of a quantity along a sweep; without `limit`, the claim is growth without bound.
struct LimitClaimed {
    formula::Expr of;
    std::optional<formula::Expr> limit;
    /// Returns the distance from the limit; the quantity itself if the limit is infinity.
    [[nodiscard]] formula::Expr difference() const { return limit ? of - *limit : of; }
};

/// One sample of a claim about a limit, in balls, followed from the last listed value to values
/// 10^1024 times as near to the end of the sweep, or as far as there are enclosures.
struct FollowedTail {
    /// The decision from the values that were computed. It does not prove anything beyond them;
    /// hidden_terms.hpp gives the conditions under which it stays undecided.
    Decision decision;
    std::string problem;               ///< the reason why nothing is decided
    std::optional<std::string> target; ///< of the sweep: "0", "infinity", "3/7", ...
    unsigned decades = 0;              ///< from the last listed value
    std::vector<std::string> texts;    ///< "about 10^512 times as near ...", each with the quantity
    std::optional<Evidence> compared;  ///< two numbers that certainly differ, and show the trend
};
[[nodiscard]] FollowedTail follow_tail(const ParameterSweep& sweep, std::size_t sample,
                                       const LimitClaimed& claimed, unsigned digits);

} // namespace edgeproof::audit
