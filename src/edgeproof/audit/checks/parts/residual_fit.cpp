// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/audit/checks/parts/residual_fit.hpp"

#include "edgeproof/formula/exact/exact.hpp"
#include "edgeproof/precision/error.hpp"

#include <cmath>

namespace edgeproof::audit {
namespace {

constexpr std::size_t points = 12;

/// Richardson's extrapolation to u = 0 of f(u) = f_0 + f_1 u + f_2 u^2 + ..., known at u_0 2^-j.
Real extrapolated(std::vector<Real> f) {
    Real power = 1;
    while (f.size() > 1) {
        power *= 2;
        for (std::size_t j = 0; j + 1 < f.size(); ++j) {
            f[j] = (power * f[j + 1] - f[j]) / (power - 1);
        }
        f.pop_back();
    }
    return f[0];
}

} // namespace

long ResidualFitOptions::bits() const {
    const double decades = start + 0.302 * static_cast<double>(points);
    const double lost = static_cast<double>(orders + 1) * decades;
    return formula::bits_for(digits + static_cast<unsigned>(std::ceil(lost)) + 20);
}

ResidualFit fit_residuals(const contact::ProvedContact& contact, contact::Edge edge,
                          const ResidualFitOptions& options,
                          std::optional<std::vector<Ball>> coefficients) {
    const std::vector<Ball> c =
        coefficients ? std::move(*coefficients) : contact.expansion(edge, options.orders);
    const PrecisionScope scope(options.digits + 10);
    const long known = formula::bits_for(options.digits);
    const Ball start(contact.reach(edge).midpoint() * pow(Real(10), -options.start),
                     contact.bits());
    ResidualFit fit;
    fit.residuals.resize(options.orders);
    for (std::size_t j = 0; j < points; ++j) {
        const Ball u = start * pow_int(Ball(2, start.bits()), -static_cast<long>(j));
        const Ball pressure = contact.pressure(edge, u);
        fit.u.push_back(at_working_precision(u.midpoint()));
        Ball sum(0, u.bits());
        Ball power = sqrt(u);
        for (std::size_t n = 0; n < options.orders; ++n) {
            const Ball residual = pressure - sum;
            if (residual.relative_accuracy_bits() < known) {
                throw BudgetError("a residual that is not enclosed");
            }
            fit.residuals[n].push_back(at_working_precision(residual.midpoint()));
            sum = n < c.size() ? sum + c[n] * power : sum;
            power *= u;
        }
    }
    for (const std::vector<Real>& r : fit.residuals) {
        std::vector<Real> local;
        for (std::size_t j = 0; j + 1 < r.size(); ++j) {
            local.push_back(log(abs(Real(r[j] / r[j + 1]))) / log(Real(2)));
        }
        fit.slopes.push_back(extrapolated(std::move(local)));
    }
    return fit;
}

} // namespace edgeproof::audit
