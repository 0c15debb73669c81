// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/arithmetic.hpp"

#include <cmath>

/// Elementary functions of Real by Arb, which is several times faster than MPFR up to some hundreds
/// of digits. As MPFR's they are rounded to the nearest number, at the working precision of the
/// thread or at x's own where that is higher. Every other function of Real is MPFR's.
namespace edgeproof {

/// atan x.
[[nodiscard]] Real arc_tangent(const Real& x);
/// sinh x.
[[nodiscard]] Real hyperbolic_sine(const Real& x);
/// e^x - 1.
[[nodiscard]] Real exp_less_one(const Real& x);

template <Arithmetic T> [[nodiscard]] T arc_tangent(const T& x) {
    using std::atan;
    return atan(x);
}
template <Arithmetic T> [[nodiscard]] T exp_less_one(const T& x) {
    using std::expm1;
    return expm1(x);
}

} // namespace edgeproof
