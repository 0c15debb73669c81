// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/real.hpp"

#include <cstddef>
#include <functional>
#include <vector>

namespace edgeproof::audit {

/// The precision with which a printed integrand is integrated as it stands, without a separate
/// variable for the distance to an end point. The nodes at `nodes` digits come as near to an end as
/// 10^-(2 nodes + 20) of the interval, and the integrand is evaluated with enough digits to resolve
/// that distance, 3 nodes + 60 for the nearest. The digits for a distance d are counted from
/// `scale`, the largest number from which d may result by subtraction. They increase in steps, so
/// that only a few precisions occur.
struct NaivePrecision {
    unsigned nodes = 0;
    Real scale = 0;      ///< 0: the maximum of the larger end point and the length
    int last_level = 14; ///< of the quadrature; beyond it, the quadrature stops
    /// True if the integrand may have roots at its ends and cuts and may be smooth between them;
    /// then few nodes are sufficient. False only saves the time to find this out.
    bool roots = true;
    [[nodiscard]] unsigned integrand() const { return 3 * nodes + 60; }
    /// Returns the digits for the integrand at a distance `decades` below the scale.
    [[nodiscard]] unsigned at(long decades) const {
        const unsigned step = nodes / 2;
        const auto beyond = static_cast<unsigned>(decades < 20 ? 0 : decades - 20);
        return nodes + 60 + (beyond + step - 1) / step * step;
    }
};

struct NaiveIntegral {
    Real value;
    Real estimate; ///< error relative to the integral of |f|, not a bound
    bool converged = true;
};

/// Thrown for an integral that has no finite value according to an estimate: its integrand grows so
/// fast at an end that the integral diverges.
class DivergentIntegral : public DomainError {
public:
    using DomainError::DomainError;
};

/// The integrand f at one point; called with the precision that the point needs.
using NaiveIntegrand = std::function<Real(const Real&)>;

/// Integrates f from lo to hi (also for hi < lo). `cuts` are places where f is not analytic: the
/// interval is split at those inside, and those outside are taken into account at a nearby end.
/// Throws DivergentIntegral if the integral does not converge and f grows at an end.
[[nodiscard]] NaiveIntegral integrate_naively(const NaiveIntegrand& f, const Real& lo,
                                              const Real& hi, std::vector<Real> cuts,
                                              const NaivePrecision& precision);

/// Computes the Cauchy principal value for lo < pole < hi from f(pole + r) + f(pole - r) near the
/// pole. Throws DomainError for a pole at an end.
[[nodiscard]] NaiveIntegral principal_value_naively(const NaiveIntegrand& f, const Real& lo,
                                                    const Real& hi, const Real& pole,
                                                    std::vector<Real> cuts,
                                                    NaivePrecision precision);

} // namespace edgeproof::audit
