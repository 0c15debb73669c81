// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/ledger/evidence.hpp"
#include "edgeproof/contact/design/design.hpp"

#include <string>

namespace edgeproof::audit {

inline constexpr long optimum_bits = 256;

/// The proved best value of a parameter (contact/design), and the shortfall of a claimed value.
struct ProvedOptimum {
    contact::BestReach best;
    Ball claimed_reach; ///< proved, too
    Ball falls_short;   ///< 1 - claimed_reach/best
    bool proved = false;
    bool is_best = false; ///< no value reaches farther than the claimed one by more than the gap
    std::string text; ///< "m = 0.66796..., where one term reaches 0.45016... of the contact; ..."

    void add_to(Evidence& evidence) const;
};

/// The gap is at most a millionth of the best reach.
[[nodiscard]] ProvedOptimum proved_optimum(const contact::ReachProblem& problem,
                                           const contact::ParameterRange& range,
                                           const Ball& claimed, const std::string& parameter);

} // namespace edgeproof::audit
