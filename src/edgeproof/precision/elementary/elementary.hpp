// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/arithmetic.hpp"

#include <cmath>

/// Elementary functions that are faster than MPFR's at some hundreds of digits, at the working
/// precision of the thread, or x's own where that is higher; the error is below 0.51 units in the
/// last place. Tables, made at first use for each precision and thread, leave a small argument to
/// the series. What is left to MPFR: nan, infinities and more digits.
namespace edgeproof {

/// atan x, by tables of atan(i/2^8) and atan(i/2^16).
[[nodiscard]] Real arc_tangent(const Real& x);
/// ln(1 + x), x > 0, by tables of ln(i/2^8) and ln(i/2^16); otherwise MPFR's.
[[nodiscard]] Real log_of_one_plus(const Real& x);
/// e^x - 1, |x| < 2^20, by tables of exp(i/2^8), exp(i/2^16) and exp(i/2^24); otherwise MPFR's.
[[nodiscard]] Real exp_less_one(const Real& x);

template <Arithmetic T> [[nodiscard]] T arc_tangent(const T& x) {
    using std::atan;
    return atan(x);
}
template <Arithmetic T> [[nodiscard]] T log_of_one_plus(const T& x) {
    using std::log1p;
    return log1p(x);
}
template <Arithmetic T> [[nodiscard]] T exp_less_one(const T& x) {
    using std::expm1;
    return expm1(x);
}

} // namespace edgeproof
