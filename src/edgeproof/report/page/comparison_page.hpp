// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/report/figures/comparison_figures.hpp"

#include <string>
#include <string_view>

namespace edgeproof::report {

/// share/edgeproof/report/cost.html when the program was built: the page of `compare` and `cost`.
namespace cost_template {
extern const std::string_view cost_html;
} // namespace cost_template

/// Returns one self-contained page: outcome, quantities, errors and, if drawn, figures of each
/// file.
[[nodiscard]] std::string comparison_page(const ComparisonReport& report,
                                          const DrawnComparison& drawn);

} // namespace edgeproof::report
