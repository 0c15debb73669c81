// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/comparison/comparison.hpp"
#include "edgeproof/report/tables/table.hpp"

#include <string>
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

} // namespace edgeproof::report
