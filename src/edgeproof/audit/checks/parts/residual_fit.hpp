// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/contact/enclosure/proved_contact.hpp"

#include <optional>
#include <vector>

namespace edgeproof::audit {

/// The residuals r_n(u) = p(u) - sum_{k<n} c_k u^(k+1/2) on a geometric sweep of u, and their
/// slopes. They are evidence for the series, because p is computed without it; they are the middles
/// of enclosures, and no bound.
struct ResidualFit {
    std::vector<Real> u;                      ///< from the far end of the sweep towards the edge
    std::vector<std::vector<Real>> residuals; ///< by n, at these places
    /// By n: the slope of log|r_n| as a function of log u, extrapolated to u = 0. It is n + 1/2 if
    /// c_0 ... c_{n-1} are right, and higher if c_n vanishes, too.
    std::vector<Real> slopes;
};

/// The sweep has 12 steps, each of which halves the distance from the edge.
struct ResidualFitOptions {
    std::size_t orders = 8; ///< n = 0 ... orders - 1
    unsigned digits = 50;   ///< of the residuals
    int start = 5; ///< the first step is at 10^-start times the reach of the expansion at the edge

    /// The number of bits of a contact for this fit. They rise with the cancellation: the last
    /// residual at the last step loses about (orders + 1) * (start + 12 log10(2)) digits.
    [[nodiscard]] long bits() const;
};

/// Fits the residuals at one edge. `coefficients` are the tested ones (for instance those of a
/// printed formula); by default those of the exact expansion. Throws BudgetError if the bits of the
/// contact do not enclose a residual.
[[nodiscard]] ResidualFit fit_residuals(const contact::ProvedContact& contact, contact::Edge edge,
                                        const ResidualFitOptions& options = {},
                                        std::optional<std::vector<Ball>> coefficients = {});

} // namespace edgeproof::audit
