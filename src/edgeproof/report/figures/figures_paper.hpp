// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/run.hpp"
#include "edgeproof/contact/profile/edge.hpp"
#include "edgeproof/contact/profile/profile.hpp"
#include "edgeproof/report/figures/figures.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace edgeproof::report {

/// The description of a figure: its names, and functions that make its panels (in any thread).
struct FigureRecipe {
    std::string id;
    std::string title;
    std::string caption;
    std::vector<std::function<Plot()>> plots;
};

/// Returns figures 2 to 9 of the paper for the ledger `name`; none for a ledger of another source.
/// Columns of a panel: fraction (u divided by the distance from the edge to the origin: 1 - x/a at
/// the right edge), x_over_a, p (in the panel's unit), p1 ... p3 (1, 2, 3 terms), e1 ... e3
/// (|1 - p_n/p|). Values are correct to `figure_digits`; a row at a corner, where p is infinite, is
/// left out. Panels of pressures have even steps of x.
[[nodiscard]] std::vector<FigureRecipe> paper_figures(const std::string& name);

/// The contacts of the paper's figures, one for each profile and set of parameters.
struct NamedScene {
    std::string id;
    std::string name;
    contact::Profile profile;
    std::string half_width;
    std::vector<contact::Edge> edges;
};
[[nodiscard]] std::vector<NamedScene> paper_scenes(const std::string& name);

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
