// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/sample/audit_context.hpp"
#include "edgeproof/precision/ball/ball.hpp"

#include <string>

namespace edgeproof::audit {

/// The approximation by a number of terms at an edge, and the tolerance of its relative error.
struct ReachQuestion {
    Edge edge = Edge::right;
    Exact terms;
    Exact tolerance;
};

/// Returns the least distance from the edge at which the tolerance is reached (`first_exit`), or
/// the total length of all places within it, proved (ball_extent.hpp). Throws BudgetError if the
/// bits do not decide, and Error if the tolerance is nowhere reached or the question has no
/// meaning.
[[nodiscard]] Ball enclosed_reach(const SceneSpec& scene, const ReachQuestion& question,
                                  bool first_exit, long bits);

/// Returns the value of a parameter between two numbers for which the first exit is greatest, as a
/// share of the contact and up to its middle: no other value is better by more than 1e-8, which is
/// proved (contact/design). Throws Error for other parameters than the exponent m of a power law.
[[nodiscard]] Ball best_value(const SceneSpec& scene, const ReachQuestion& question,
                              const std::string& parameter, const Exact& from, const Exact& to);

} // namespace edgeproof::audit
