// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/report/figures/figures.hpp"
#include "lab/cost/cost_tables.hpp"

#include <vector>

namespace edgeproof::report {

/// For the first case: digits reached against evaluations and against time; growth with the digits
/// on logarithmic axes, with the fitted exponents; cost against the distance from the edge. For the
/// case near a knot, if there is one: cost against the distance from it. For all cases: the cost of
/// a proof. Figures without data are left out.
[[nodiscard]] std::vector<Figure> cost_figures(const CostReport& report);

} // namespace edgeproof::report
