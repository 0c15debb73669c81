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

/// A row that compares data and exact contact for one quantity.
struct HeldQuantity {
    std::string name; ///< "a", "P", "c_0 left", ...
    std::string unit;
    std::optional<double> data;
    double spread = 0;              ///< of the data's value, if a fit gives one
    std::optional<double> of_exact; ///< the result of the same rule for the exact pressure
    double exact = 0;
    std::string note;
};
[[nodiscard]] std::vector<HeldQuantity> held_quantities(const ComparisonReport& report,
                                                        const comparison::FileComparison& file);

/// Returns the tolerances as text: "p within 3 % of the peak, ...".
[[nodiscard]] std::string tolerance_text(const comparison::Tolerances& t);

/// Returns the report as text: for each file the findings, the quantities, the errors by distance
/// and near knots, and the reasons of failure; orders of several files; the outcome in
/// the last line.
[[nodiscard]] std::string comparison_text(const ComparisonReport& report);
/// Returns the report as JSON; all numbers are binary64.
[[nodiscard]] std::string comparison_json(const ComparisonReport& report);

} // namespace edgeproof::report
