// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/precision/elementary/gamma_taylor.hpp"

#include "edgeproof/precision/ball/acb_values.hpp"
#include "edgeproof/precision/ball/ball.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>

namespace edgeproof {

std::vector<Real> gamma_taylor(const Real& x, std::size_t n) {
    if (!isfinite(x)) {
        throw DomainError("gamma of a number that is not finite");
    }
    constexpr long guard_bits = 64;
    const long bits = mpfr_get_prec(Real(x).backend().data()) + guard_bits;
    const Ball at(x, bits);
    AcbPolyValue f;
    AcbValue c;
    acb_set_arb(c, at.data());
    acb_poly_set_coeff_acb(f, 0, c);
    acb_poly_set_coeff_si(f, 1, 1);
    acb_poly_gamma_series(f, f, static_cast<slong>(n), bits);
    std::vector<Real> series;
    bool finite = true;
    for (std::size_t k = 0; k < n; ++k) {
        acb_poly_get_coeff_acb(c, f, static_cast<slong>(k));
        Ball coefficient(0, bits);
        arb_set(coefficient.data(), acb_realref(c));
        finite = finite && coefficient.is_finite();
        series.push_back(finite ? at_working_precision(coefficient.midpoint()) : Real(0));
    }
    if (!finite) {
        throw DomainError("gamma at a pole");
    }
    return series;
}

Real gamma_difference(const Real& x, const Real& h) {
    if (h == 0) {
        return Real(0);
    }
    const unsigned digits = working_digits();
    // The number of decades that the difference loses. If it exceeds all digits, the derivative
    // suffices.
    const Real ratio = abs(Real(h / (abs(x) + 1)));
    const Real lost = ratio < 1 ? Real(-log10(ratio)) : Real(0);
    if (lost > digits) {
        return Real(gamma_taylor(x, 2)[1] * h);
    }
    constexpr unsigned guard_digits = 5;
    const Real difference = [&] {
        const PrecisionScope scope(digits + lost.convert_to<unsigned>() + guard_digits);
        return Real(gamma_taylor(Real(x + h), 1)[0] - gamma_taylor(x, 1)[0]);
    }();
    return at_working_precision(difference);
}

} // namespace edgeproof
