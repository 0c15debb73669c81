// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/audit/run.hpp"
#include "edgeproof/report/figures/figures.hpp"
#include "edgeproof/scene/input/scene_file.hpp"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

/// The figures of the page of an audit.
namespace edgeproof::report {

/// The description of a figure: its names, and functions that make its panels (in any thread).
struct FigureRecipe {
    std::string id;
    std::string title;
    std::string caption;
    std::vector<std::function<std::optional<Plot>()>> plots;
};

struct FiguresOfSource {
    std::vector<FigureRecipe> printed; ///< the figures of the source, recomputed
    /// The residuals of the pressure near the edges of scenes after 0 ... 7 terms against the
    /// distance u on logarithmic axes, each order with its fitted slope (1/2 to 15/2 if no
    /// coefficient vanishes). Columns: u, r0 ... r7 (absolute values).
    std::vector<FigureRecipe> residuals;
};
/// Reads figures/NAME.toml in the folder of the ledger NAME.toml (verify/README.md); empty if there
/// is no such file. The panels are those of scene_picture(). Throws InputError.
[[nodiscard]] FiguresOfSource figures_of_source(const std::filesystem::path& ledger);

/// For a refuted claim about a coefficient (`of` is right.cK or left.cK): plots the residual of the
/// pressure after K + 1 terms, with the last coefficient as printed and as corrected, in the first
/// scene of the claim's family that distinguishes them. As printed the slope stays at K + 1/2; as
/// corrected it is K + 3/2. Columns: u_over_length, printed, corrected. Returns nothing for claims
/// of another form, or if no scene refutes the claim.
[[nodiscard]] std::optional<Plot> erratum_plot(const audit::ClaimResult& result,
                                               const audit::Ledger& ledger);

} // namespace edgeproof::report
