// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/real.hpp"

#include <cstddef>
#include <functional>
#include <vector>

namespace edgeproof {

/// How a printed integrand is integrated as it stands, with no distance to its end points split
/// off: the nodes at `nodes` digits come as near to an end as 10^-(2 nodes + 20) of the interval,
/// and the integrand is evaluated at `integrand` digits, enough to see that distance.
struct NaivePrecision {
    unsigned nodes = 0;
    [[nodiscard]] unsigned integrand() const { return 3 * nodes + 60; }
};

struct NaiveIntegral {
    Real value;
    Real estimate; ///< relative to the integral of |f|; an estimate
    bool converged = true;
};

/// f at one point; called at the integrand's precision.
using Integrand = std::function<Real(const Real&)>;

/// The integral of f from lo to hi (also for hi < lo). `cuts` are places where f is not analytic,
/// inside (the interval is split there) or outside (an end near to one is taken care of).
[[nodiscard]] NaiveIntegral integrate_naively(const Integrand& f, const Real& lo, const Real& hi,
                                              std::vector<Real> cuts, NaivePrecision precision);

/// The Cauchy principal value at lo < pole < hi: f(pole + r) + f(pole - r) near it.
/// Throws DomainError for a pole that is not inside.
[[nodiscard]] NaiveIntegral principal_value_naively(const Integrand& f, const Real& lo,
                                                    const Real& hi, const Real& pole,
                                                    std::vector<Real> cuts,
                                                    NaivePrecision precision);

} // namespace edgeproof
