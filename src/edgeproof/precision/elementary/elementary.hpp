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

} // namespace edgeproof
