// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/run.hpp"
#include "edgeproof/report/figures/figures_paper.hpp"

#include <optional>

namespace edgeproof::report {

/// What is left of the pressure near an edge after 0 ... 7 terms, log-log against the distance u,
/// each order with its fitted slope (1/2 to 15/2 where no coefficient vanishes).
/// Columns: u, r0 ... r7 (absolute values).
[[nodiscard]] Plot residual_fit_plot(const NamedScene& scene, contact::Edge edge);
/// One panel an edge.
[[nodiscard]] std::vector<FigureRecipe> residual_figures(const std::string& name);

/// Of a claim about a coefficient (`of` is right.cK or left.cK) that is refuted: what is left of
/// the pressure after K + 1 terms, the last as printed and as corrected, in the first scene of the
/// claim's family that tells them apart. As printed the slope stays at K + 1/2; as corrected it is
/// K + 3/2. Columns: u_over_length, printed, corrected.
/// Nothing for claims of another form, or that no scene refutes.
[[nodiscard]] std::optional<Plot> erratum_plot(const audit::ClaimResult& result,
                                               const audit::Ledger& ledger);

} // namespace edgeproof::report
