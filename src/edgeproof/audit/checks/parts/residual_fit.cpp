// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/checks/parts/residual_fit.hpp"

#include "edgeproof/contact/batch/batch_pressure.hpp"
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <cmath>

namespace edgeproof::audit {
namespace {

/// Richardson's extrapolation to u = 0 of f(u) = f_0 + f_1 u + f_2 u^2 + ..., known at u_0 2^-j.
struct Extrapolated {
    Real value;
    Real change;
};
Extrapolated extrapolate(std::vector<Real> f) {
    Real previous = f.back();
    Real power = 1;
    while (f.size() > 1) {
        power *= 2;
        previous = f.back();
        for (std::size_t j = 0; j + 1 < f.size(); ++j) {
            f[j] = (power * f[j + 1] - f[j]) / (power - 1);
        }
        f.pop_back();
    }
    return {f[0], Real(abs(f[0] - previous))};
}

int digits_of_agreement(const Real& x, const Real& y, const Real& scale, unsigned most) {
    const Real d = abs(x - y);
    if (d == 0) {
        return static_cast<int>(most);
    }
    const Real relative = log10(scale / d);
    return relative > most ? static_cast<int>(most) : static_cast<int>(floor(relative));
}

} // namespace

std::vector<OrderFit> fit_residuals(const contact::Profile& profile, const Exact& contact_modulus,
                                    const contact::Load& load, Edge edge,
                                    const ResidualFitOptions& options,
                                    const std::optional<std::vector<Real>>& coefficients) {
    if (options.points < 3 || options.orders == 0) {
        throw DomainError("a residual fit needs at least one order and three points");
    }
    const double decades = options.start + 0.302 * static_cast<double>(options.points);
    const auto lost =
        static_cast<unsigned>(std::ceil(static_cast<double>(options.orders) * decades));
    const unsigned digits = options.digits + lost + 10;
    const contact::NormalContact contact(profile, contact_modulus, load, digits);
    const PrecisionScope scope(digits + 10);

    const std::vector<Real> exact = contact.expansion(edge, coefficients ? 1 : options.orders + 1);
    std::vector<Real> c = coefficients.value_or(exact);
    if (c.size() < options.orders) {
        throw DomainError("a residual fit of " + std::to_string(options.orders) +
                          " orders needs as many coefficients");
    }
    const Real radius = contact.convergence_radius(edge);
    std::vector<Real> places;
    std::vector<Real> pressure;
    for (std::size_t j = 0; j < options.points; ++j) {
        places.push_back(ldexp(Real(radius * pow(Real(10), -options.start)), -static_cast<int>(j)));
    }
    if (options.route == contact::Route::singular_integral ||
        (options.route == contact::Route::automatic &&
         !contact::BallContact::has_closed_form(profile))) {
        // For many points of one contact, the nodes and slopes are computed only once.
        const contact::BatchPressure p(contact, digits);
        for (const Real& u : places) {
            pressure.push_back(p(edge, u).value);
        }
    } else {
        for (const Real& u : places) {
            pressure.push_back(contact.pressure(edge, u, options.route).value);
        }
    }

    std::vector<OrderFit> fits;
    for (std::size_t n = 0; n < options.orders; ++n) {
        OrderFit fit;
        fit.n = n;
        fit.u = places;
        std::vector<Real> quotient;
        for (std::size_t j = 0; j < places.size(); ++j) {
            const Real& u = places[j];
            Real sum = 0;
            for (std::size_t k = n; k-- > 0;) {
                sum = sum * u + c[k];
            }
            fit.residual.push_back(pressure[j] - sqrt(u) * sum);
            quotient.push_back(fit.residual[j] / (sqrt(u) * pow(u, static_cast<int>(n))));
        }
        for (std::size_t j = 0; j + 1 < places.size(); ++j) {
            const Real ratio =
                fit.residual[j + 1] == 0 ? Real(0) : Real(fit.residual[j] / fit.residual[j + 1]);
            fit.local_slope.push_back(ratio > 0 ? Real(log(ratio) / log(Real(2))) : Real(0));
        }
        fit.slope = extrapolate(fit.local_slope).value;
        const Extrapolated limit = extrapolate(quotient);
        fit.coefficient = limit.value;
        fit.spread = limit.change;
        fit.expected = c[n];
        // A coefficient is taken to vanish by comparison with the size that its neighbours suggest.
        const Real natural = abs(exact[0]) * pow(radius, -static_cast<int>(n));
        const Real negligible = natural * pow(Real(10), 5 - static_cast<int>(options.digits));
        fit.vanishing = abs(fit.coefficient) < negligible && abs(fit.expected) < negligible;
        const Real scale = std::max(Real(abs(fit.expected)), Real(abs(fit.coefficient)));
        fit.agreeing_digits = digits_of_agreement(fit.coefficient, fit.expected,
                                                  fit.vanishing ? natural : scale, options.digits);
        const Real order = Real(static_cast<int>(n)) + Real(1) / 2;
        const Real off = abs(fit.slope - order - (fit.vanishing ? 1 : 0));
        fit.confirmed =
            off < pow(Real(10), -10) && fit.agreeing_digits + 5 >= static_cast<int>(options.digits);
        fits.push_back(std::move(fit));
    }
    return fits;
}

} // namespace edgeproof::audit
