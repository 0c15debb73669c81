// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/scene/design/design_file.hpp"

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace edgeproof::scene {

inline constexpr unsigned most_design_digits = 1000;

/// What a design found.
struct DesignResult {
    contact::BestReach best;
    /// Empty where everything is proved; else why the result is an estimate.
    std::string missing;
    [[nodiscard]] bool proved() const { return best.proved && missing.empty(); }
    /// The reach for the values that are printed somewhere, proved where `best` has a proof.
    std::optional<Ball> printed_reach;
    std::optional<Ball> falls_short; ///< 1 - printed_reach/best
    /// Of one parameter: value and reach (or measure) at samples, for a picture.
    std::vector<std::pair<double, double>> curve;
};

struct DesignRunOptions {
    contact::DesignOptions search;
    bool curve = false;
};

/// Throws InputError, with the line, for a value that makes no scene; BudgetError where no reach is
/// found; Interrupted.
[[nodiscard]] DesignResult run_design(const DesignScene& design, const DesignRunOptions& options);

} // namespace edgeproof::scene
