// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/routes/normal_contact.hpp"

#include <optional>
#include <vector>

namespace edgeproof::audit {

/// The residual r_n(u) = p(u) - sum_{k<n} c_k u^(k+1/2) on a geometric sweep of u. All figures are
/// extrapolated from values of p that were computed without the series, so that they are evidence
/// for it; none is a proved bound.
struct OrderFit {
    std::size_t n = 0;
    std::vector<Real> u;           ///< the sweep, from its far end towards the edge
    std::vector<Real> residual;    ///< r_n at these places
    std::vector<Real> local_slope; ///< of log|r_n| as a function of log u, between neighbours
    Real slope;                    ///< extrapolated to u = 0; n + 1/2 if c_0 ... c_{n-1} are right
    Real coefficient;              ///< extrapolated r_n/u^(n+1/2)
    Real spread;                   ///< the change of `coefficient` by the last extrapolation
    Real expected;                 ///< the tested coefficient c_n
    int agreeing_digits = 0;       ///< digits of agreement between `coefficient` and `expected`
    /// True if c_n is zero to the working digits: then the slope is that of the next term, n + 3/2.
    bool vanishing = false;
    /// True if the order is n + 1/2 (to 1e-10) and the coefficient agrees (to the requested
    /// digits), or if c_n vanishes in both.
    bool confirmed = false;
};

struct ResidualFitOptions {
    std::size_t orders = 8;  ///< n = 0 ... orders - 1
    std::size_t points = 12; ///< steps of the sweep; each halves the distance from the edge
    unsigned digits = 50;    ///< requested digits of each coefficient
    /// The first step is at 10^-start radii of convergence.
    int start = 5;
    contact::Route route = contact::Route::singular_integral;
};

/// Fits the residuals at one edge. `coefficients` are the tested ones (for instance those of a
/// printed formula); by default those of the exact expansion. The working precision rises with the
/// cancellation: the last residual at the last step loses about orders * (start + points log10(2))
/// digits, and this number of digits is added.
[[nodiscard]] std::vector<OrderFit>
fit_residuals(const contact::Profile& profile, const Exact& contact_modulus,
              const contact::Load& load, Edge edge, const ResidualFitOptions& options = {},
              const std::optional<std::vector<Real>>& coefficients = {});

} // namespace edgeproof::audit
