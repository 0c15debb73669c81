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

struct DesignResult {
    contact::BestReach best;
    /// Empty if everything is proved; otherwise the reason why the result is an estimate.
    std::string missing;
    [[nodiscard]] bool proved() const { return best.proved && missing.empty(); }
    /// The reach for the printed values, proved if `best` is proved.
    std::optional<Ball> printed_reach;
    std::optional<Ball> falls_short; ///< 1 - printed_reach/best
    /// For one parameter: samples of value and reach (or measure), for a picture.
    std::vector<std::pair<double, double>> curve;
};

struct DesignRunOptions {
    contact::DesignOptions search;
    bool curve = false;
};

/// Throws InputError, with the line, for a value that does not make a valid scene; BudgetError if
/// no reach is found; Interrupted.
[[nodiscard]] DesignResult run_design(const DesignScene& design, const DesignRunOptions& options);

} // namespace edgeproof::scene
