// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/cost/cost.hpp"
#include "edgeproof/report/tables/table.hpp"

#include <string>
#include <utility>
#include <vector>

namespace edgeproof::report {

/// All that `edgeproof cost` has found.
struct CostReport {
    std::vector<std::pair<std::string, std::string>> machine;
    std::vector<unsigned> digits; ///< asked for, ascending
    std::vector<cost::CostCase> cases;
    std::vector<cost::CostCell> cells;
    std::vector<cost::EffectCost> effects; ///< empty where scenes of the user's were timed

    /// Those that what is not shown at all digits is shown at: 50, or what lies in the middle.
    [[nodiscard]] unsigned usual_digits() const;
    [[nodiscard]] const cost::CostCase& case_named(const std::string& name) const;
};

/// "4.21 us", "1.30 ms", "0.83 s".
[[nodiscard]] std::string time_text(double seconds);

/// For reading: one row a route and number of digits.
[[nodiscard]] Table cost_table(const CostReport& report, const std::string& scene);
/// For reading: one number of digits, all scenes.
[[nodiscard]] Table cost_table_at(const CostReport& report, unsigned digits);
[[nodiscard]] Table growth_table(const CostReport& report);
[[nodiscard]] Table bound_table(const CostReport& report);
[[nodiscard]] Table effect_table(const CostReport& report);

/// For programs: times in seconds, every cell and every point.
[[nodiscard]] Table cost_cells(const CostReport& report);
[[nodiscard]] Table cost_points(const CostReport& report);
/// Both of these, the growth, the bounds, the effects and the machine as one JSON text.
[[nodiscard]] std::string cost_json(const CostReport& report);

} // namespace edgeproof::report
