// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/enclosure/enclosed_sample.hpp"
#include "edgeproof/audit/ledger/judgement.hpp"
#include "edgeproof/contact/design/best_reach.hpp"
#include "edgeproof/contact/enclosure/ball_extent.hpp"

#include <optional>
#include <string>

namespace edgeproof::audit {

/// The approximation, the edge, the tolerance and the range of a reach.
struct ReachQuestion {
    Edge edge = Edge::right;
    std::size_t terms = 1;
    Exact tolerance;
    contact::ExtentRange range;
};

/// The proved extents in which n terms are within a tolerance in a scene. If no number of bits up
/// to 8 times that of `digits` decides, `extents` is empty and `problem` gives the reason.
struct EnclosedReach {
    std::optional<contact::EnclosedExtents> extents;
    long bits = 0;
    std::string problem;
};
[[nodiscard]] EnclosedReach enclosed_reach(const SceneSpec& scene, const ReachQuestion& question,
                                           unsigned digits);

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
