// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/report/figures/figures.hpp"
#include "edgeproof/report/tables/table.hpp"
#include "lab/cost/cost.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace edgeproof::report {

struct CostReport {
    std::vector<std::pair<std::string, std::string>> machine;
    std::vector<unsigned> digits; ///< the requested digits, ascending
    std::vector<cost::CostCase> cases;
    std::vector<cost::CostCell> cells;
    std::vector<cost::EffectCost> effects; ///< empty if the user's own scenes were timed

    /// The number of digits for results shown at one number only: 50, or the middle one.
    [[nodiscard]] unsigned usual_digits() const;
    /// The number of digits for the effects: a tilt found from P and M has at most about 1200.
    [[nodiscard]] unsigned effect_digits() const { return std::min(usual_digits(), 1000U); }
    [[nodiscard]] const cost::CostCase& case_named(const std::string& name) const;
};

/// For example "4.21 us", "1.30 ms", "0.83 s".
[[nodiscard]] std::string time_text(double seconds);

/// A table for readers: one row per route and number of digits.
[[nodiscard]] Table cost_table(const CostReport& report, const std::string& scene);
/// A table for readers: one number of digits, all scenes.
[[nodiscard]] Table cost_table_at(const CostReport& report, unsigned digits);
[[nodiscard]] Table growth_table(const CostReport& report);
[[nodiscard]] Table bound_table(const CostReport& report);
[[nodiscard]] Table effect_table(const CostReport& report);

/// Tables for programs: times in seconds, every cell and every point.
[[nodiscard]] Table cost_cells(const CostReport& report);
[[nodiscard]] Table cost_points(const CostReport& report);
/// Returns both of these, the growth, the bounds, the effects and the machine as JSON.
[[nodiscard]] std::string cost_json(const CostReport& report);

/// For the first case: digits reached against evaluations and against time; growth with the digits
/// on logarithmic axes, with the fitted exponents; cost against the distance from the edge. For the
/// case near a knot, if there is one: cost against the distance from it. For all cases: the cost of
/// a proof. Figures without data are left out.
[[nodiscard]] std::vector<Figure> cost_figures(const CostReport& report);

} // namespace edgeproof::report
