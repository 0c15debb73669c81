// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/report/figures/comparison_figures.hpp"

#include <string>

namespace edgeproof::report {

/// Returns one self-contained page: outcome, quantities, errors and, if drawn, figures of each
/// file.
[[nodiscard]] std::string comparison_page(const ComparisonReport& report,
                                          const DrawnComparison& drawn);

} // namespace edgeproof::report
