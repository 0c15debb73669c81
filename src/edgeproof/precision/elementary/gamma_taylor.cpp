// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/precision/elementary/gamma_taylor.hpp"
#include "edgeproof/precision/ball/acb_values.hpp"
#include "edgeproof/precision/ball/ball.hpp"
#include "edgeproof/precision/error.hpp"

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

} // namespace edgeproof
