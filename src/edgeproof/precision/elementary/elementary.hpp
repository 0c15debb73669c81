// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/arithmetic.hpp"

#include <cmath>
#include <cstddef>
#include <vector>

/// Elementary functions of Real by Arb, which is several times faster than MPFR up to some hundreds
/// of digits. Like those of MPFR they are rounded to nearest, at the working precision of the
/// thread or at that of x where it is higher. Every other function of Real is MPFR's.
namespace edgeproof {

/// Returns atan x.
[[nodiscard]] Real arc_tangent(const Real& x);
/// Returns sinh x.
[[nodiscard]] Real hyperbolic_sine(const Real& x);
/// Returns e^x - 1.
[[nodiscard]] Real exp_less_one(const Real& x);

template <Arithmetic T> [[nodiscard]] T arc_tangent(const T& x) {
    using std::atan;
    return atan(x);
}
template <Arithmetic T> [[nodiscard]] T exp_less_one(const T& x) {
    using std::expm1;
    return expm1(x);
}

/// Returns the first n coefficients of the Taylor series of the gamma function about x, at the
/// working precision, by Arb. Throws DomainError at a pole.
[[nodiscard]] std::vector<Real> gamma_taylor(const Real& x, std::size_t n);

/// Returns gamma(x + h) - gamma(x) without cancellation. Throws DomainError at a pole.
[[nodiscard]] Real gamma_difference(const Real& x, const Real& h);

/// The number of digits used for the machine formats.
constexpr unsigned gamma_digits = 50;

template <Arithmetic T> [[nodiscard]] std::vector<T> gamma_taylor_in(const T& x, std::size_t n) {
    if constexpr (std::same_as<T, Real>) {
        return gamma_taylor(x, n);
    } else {
        const PrecisionScope scope(gamma_digits);
        std::vector<T> series;
        for (const Real& c : gamma_taylor(Real(x), n)) {
            series.push_back(c.convert_to<T>());
        }
        return series;
    }
}

template <Arithmetic T> [[nodiscard]] T gamma_difference_in(const T& x, const T& h) {
    if constexpr (std::same_as<T, Real>) {
        return gamma_difference(x, h);
    } else {
        const PrecisionScope scope(gamma_digits);
        return gamma_difference(Real(x), Real(h)).template convert_to<T>();
    }
}

} // namespace edgeproof
