// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/comparison/comparison.hpp"
#include "edgeproof/report/tables/table.hpp"

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace edgeproof::report {

/// The comparison of results with the exact contact, for a report.
struct ComparisonReport {
    std::string scene; ///< file
    std::string title;
    std::optional<scene::Units> units;
    const comparison::ExactContact* exact = nullptr;
    comparison::Comparison comparison;
};

/// Returns the tolerances as text: "p within 3 % of the peak, ...".
[[nodiscard]] std::string tolerance_text(const comparison::Tolerances& t);

/// Returns the report as text: for each file the findings, the quantities, the errors by distance
/// and near knots, and the reasons of failure; orders of several files; the outcome in
/// the last line.
[[nodiscard]] std::string comparison_text(const ComparisonReport& report);
/// Returns the report as JSON; all numbers are binary64.
[[nodiscard]] std::string comparison_json(const ComparisonReport& report);

/// What a comparison found: the report as text and as JSON.
struct ComparedResults {
    bool passes = false;
    std::string text;
    std::string json;
};

/// Compares texts of results, each with the name of its file, with the exact contact. `name`: the
/// file of the scene. Options (docs/compare.md): columns, scale, origin, tolerance, of, edge_zone,
/// tolerance_a, tolerance_P, tolerance_c0, tolerance_q, tolerance_surface, partial. Throws
/// InputError.
[[nodiscard]] ComparedResults
compare_results(const std::function<void(std::size_t, std::size_t)>& progress,
                const scene::Scene& scene, const std::string& name,
                const std::vector<std::pair<std::string, std::string>>& results,
                const std::map<std::string, std::string, std::less<>>& options);

} // namespace edgeproof::report
