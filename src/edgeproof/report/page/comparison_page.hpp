// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/report/tables/comparison_report.hpp"

#include <string>

namespace edgeproof::report {

/// One page that needs nothing else: outcome, quantities, errors and, where gnuplot is installed,
/// figures of each file.
[[nodiscard]] std::string comparison_page(const ComparisonReport& report);

} // namespace edgeproof::report
