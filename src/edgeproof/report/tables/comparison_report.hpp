// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/comparison/comparison.hpp"

#include <string>
#include <vector>

namespace edgeproof::report {

/// Results held against the exact contact, to be reported.
struct ComparisonReport {
    std::string scene; ///< file
    std::string title;
    std::optional<scene::Units> units;
    const comparison::ExactContact* exact = nullptr;
    comparison::Comparison comparison;
};

/// A row of what data and the exact contact have of one quantity.
struct HeldQuantity {
    std::string name; ///< "a", "P", "c_0 left", ...
    std::string unit;
    std::optional<double> data;
    double spread = 0;              ///< of the data's, where a fit gives one
    std::optional<double> of_exact; ///< what the same rule makes of the exact pressure
    double exact = 0;
    std::string route; ///< of the exact value
    std::string note;
};
[[nodiscard]] std::vector<HeldQuantity> held_quantities(const ComparisonReport& report,
                                                        const comparison::FileComparison& file);

/// "from 1e-3 to 1e-2 of a + b"
[[nodiscard]] std::string distance_text(const comparison::DistanceErrors& d);
/// What would explain a file that is off, a sentence each.
[[nodiscard]] std::vector<std::string> diagnosis_lines(const comparison::FileComparison& file);
/// What is held against what: "p within 3 % of the peak, ...".
[[nodiscard]] std::string tolerance_text(const comparison::Tolerances& t);

/// For people: for each file what was found, the quantities, the errors by distance and beside
/// knots, and why it fails; orders and limits of several; the outcome in the last line.
[[nodiscard]] std::string comparison_text(const ComparisonReport& report);
/// The same as JSON; numbers of the data are binary64, and so are the exact ones beside them.
[[nodiscard]] std::string comparison_json(const ComparisonReport& report);
/// JUnit XML: a suite a file, a case a quantity held.
[[nodiscard]] std::string comparison_junit(const ComparisonReport& report);

} // namespace edgeproof::report
