// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/run.hpp"
#include "edgeproof/report/figures/figures_paper.hpp"

#include <optional>

namespace edgeproof::report {

/// Plots the residual of the pressure near an edge after 0 ... 7 terms against the distance u on
/// logarithmic axes, each order with its fitted slope (1/2 to 15/2 if no coefficient vanishes).
/// Columns: u, r0 ... r7 (absolute values).
[[nodiscard]] Plot residual_fit_plot(const NamedScene& scene, contact::Edge edge);
/// One panel per edge.
[[nodiscard]] std::vector<FigureRecipe> residual_figures(const std::string& name);

/// For a refuted claim about a coefficient (`of` is right.cK or left.cK): plots the residual of the
/// pressure after K + 1 terms, with the last coefficient as printed and as corrected, in the first
/// scene of the claim's family that distinguishes them. As printed the slope stays at K + 1/2; as
/// corrected it is K + 3/2. Columns: u_over_length, printed, corrected. Returns nothing for claims
/// of another form, or if no scene refutes the claim.
[[nodiscard]] std::optional<Plot> erratum_plot(const audit::ClaimResult& result,
                                               const audit::Ledger& ledger);

} // namespace edgeproof::report
