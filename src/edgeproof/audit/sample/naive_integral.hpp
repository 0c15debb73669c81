// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/real.hpp"

#include <cstddef>
#include <functional>
#include <vector>

namespace edgeproof::audit {

/// How a printed integrand is integrated as it stands, with no distance to its end points split
/// off: the nodes at `nodes` digits come as near to an end as 10^-(2 nodes + 20) of the interval,
/// and the integrand is evaluated at as many digits as that distance takes to be seen, 3 nodes + 60
/// for the nearest. What a distance d takes is counted from `scale`, the largest number that d may
/// be left over from, in steps, so that a caller need not be ready for every precision there is.
struct NaivePrecision {
    unsigned nodes = 0;
    Real scale = 0;      ///< 0: the larger end point, and the length
    int last_level = 14; ///< of the quadrature, where it gives up
    /// Whether the integrand may be one of roots at its ends and cuts, smooth between, for which
    /// few nodes do. False only saves the time to find out.
    bool roots = true;
    [[nodiscard]] unsigned integrand() const { return 3 * nodes + 60; }
    /// Digits to evaluate the integrand at, `decades` below the scale.
    [[nodiscard]] unsigned at(long decades) const {
        const unsigned step = nodes / 2;
        const auto beyond = static_cast<unsigned>(decades < 20 ? 0 : decades - 20);
        return nodes + 60 + (beyond + step - 1) / step * step;
    }
};

struct NaiveIntegral {
    Real value;
    Real estimate; ///< relative to the integral of |f|; an estimate
    bool converged = true;
};

/// An integral that has no finite value, as far as an estimate tells: its integrand grows at an end
/// as no integral bears.
class DivergentIntegral : public DomainError {
public:
    using DomainError::DomainError;
};

/// f at one point; called at the precision that the point takes.
using NaiveIntegrand = std::function<Real(const Real&)>;

/// The integral of f from lo to hi (also for hi < lo). `cuts` are places where f is not analytic,
/// inside (the interval is split there) or outside (an end near to one is taken care of).
/// Throws DivergentIntegral for one that does not converge and grows at an end.
[[nodiscard]] NaiveIntegral integrate_naively(const NaiveIntegrand& f, const Real& lo,
                                              const Real& hi, std::vector<Real> cuts,
                                              const NaivePrecision& precision);

/// The Cauchy principal value at lo < pole < hi: f(pole + r) + f(pole - r) near it.
/// Throws DomainError for a pole that is not inside.
[[nodiscard]] NaiveIntegral principal_value_naively(const NaiveIntegrand& f, const Real& lo,
                                                    const Real& hi, const Real& pole,
                                                    std::vector<Real> cuts,
                                                    NaivePrecision precision);

} // namespace edgeproof::audit
