// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/routes/normal_contact.hpp"

#include <optional>
#include <vector>

namespace edgeproof::audit {

/// What the residual r_n(u) = p(u) - sum_{k<n} c_k u^(k+1/2) shows on a geometric sweep of u.
/// All figures are extrapolated from values of p that know nothing of the series, so they are
/// evidence for it; none is a proved bound.
struct OrderFit {
    std::size_t n = 0;
    std::vector<Real> u;           ///< the sweep, from its far end inwards
    std::vector<Real> residual;    ///< r_n there
    std::vector<Real> local_slope; ///< of log|r_n| against log u, between neighbours
    Real slope;                    ///< extrapolated to u = 0; n + 1/2 if c_0 ... c_{n-1} are right
    Real coefficient;              ///< extrapolated r_n/u^(n+1/2)
    Real spread;                   ///< change of `coefficient` by the last extrapolation
    Real expected;                 ///< c_n of the coefficients under test
    int agreeing_digits = 0;       ///< of `coefficient` with `expected`
    /// c_n is zero as far as the digits tell: the slope is then that of the next term, n + 3/2.
    bool vanishing = false;
    /// The order is n + 1/2 (to 1e-10) and the coefficient agrees (to the digits wanted), or c_n
    /// vanishes in both.
    bool confirmed = false;
};

struct ResidualFitOptions {
    std::size_t orders = 8;  ///< n = 0 ... orders - 1
    std::size_t points = 12; ///< steps of the sweep, each half as far from the edge
    unsigned digits = 50;    ///< wanted of each coefficient
    /// The first step, in radii of convergence: 10^-start.
    int start = 5;
    contact::Route route = contact::Route::singular_integral;
};

/// Fits the residuals at one edge. `coefficients` are those under test (a printed formula's, say);
/// by default those of the exact expansion. The working precision rises with the cancellation:
/// the last residual at the last step loses about orders * (start + points log10(2)) digits, and
/// so many more are computed.
[[nodiscard]] std::vector<OrderFit>
fit_residuals(const contact::Profile& profile, const formula::Exact& contact_modulus,
              const contact::Load& load, contact::Edge edge, const ResidualFitOptions& options = {},
              const std::optional<std::vector<Real>>& coefficients = {});

} // namespace edgeproof::audit
