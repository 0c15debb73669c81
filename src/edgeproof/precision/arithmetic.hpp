// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/rational.hpp"
#include "edgeproof/precision/real.hpp"

#include <boost/math/constants/constants.hpp>

#include <cmath>
#include <concepts>
#include <limits>
#include <type_traits>

namespace edgeproof {

/// The number types of templates that are compiled once, in a source file: binary64, for starting
/// values, and arbitrary precision.
template <class T>
concept Arithmetic = std::same_as<T, double> || std::same_as<T, Real>;
#define EDGEPROOF_FOR_EACH_ARITHMETIC(M) M(double) M(Real)

/// Returns the number nearest to q in T (`Real`: at the working precision). There is one rounding
/// for `Real`, and two for double.
template <Arithmetic T> [[nodiscard]] T from_rational(const Rational& q) {
    if constexpr (std::same_as<T, Real>) {
        Real x;
        mpfr_set_q(x.backend().data(), q.backend().data(), MPFR_RNDN);
        return x;
    } else {
        // The second rounding is correct except in a vanishing fraction of cases, where the result
        // is within one unit in the last place.
        Real x(0, 40U);
        mpfr_set_q(x.backend().data(), q.backend().data(), MPFR_RNDN);
        return x.convert_to<T>();
    }
}

/// Returns pi in T (`Real`: at the working precision).
template <Arithmetic T> [[nodiscard]] T pi() {
    if constexpr (std::same_as<T, Real>) {
        Real x;
        mpfr_const_pi(x.backend().data(), MPFR_RNDN);
        return x;
    } else {
        return boost::math::constants::pi<T>();
    }
}

/// Returns the distance from 1 to the next larger number in T (`Real`: at the working precision).
template <Arithmetic T> [[nodiscard]] T unit_roundoff() {
    if constexpr (std::same_as<T, Real>) {
        Real one(1);
        const mpfr_prec_t bits = mpfr_get_prec(one.backend().data());
        return ldexp(one, static_cast<int>(1 - bits));
    } else {
        return std::numeric_limits<T>::epsilon();
    }
}

/// Returns the number of decimal digits of T (`Real`: the working precision).
template <Arithmetic T> [[nodiscard]] unsigned digits_of() {
    if constexpr (std::same_as<T, Real>) {
        return working_digits();
    } else {
        return static_cast<unsigned>(std::numeric_limits<T>::digits10);
    }
}

/// Returns x^n for n > 0 by repeated squaring, for any type with products.
template <class T> [[nodiscard]] T repeated_product(const T& x, unsigned long n) {
    T square = x;
    while ((n & 1UL) == 0) {
        square = T(square * square);
        n >>= 1U;
    }
    T y = square;
    while ((n >>= 1U) != 0) {
        square = T(square * square);
        if ((n & 1UL) != 0) {
            y = T(y * square);
        }
    }
    return y;
}

/// Returns x^n for every n; `one` is 1 of the type, and 1/x is used where n < 0.
template <class T> [[nodiscard]] T power_by_squaring(const T& one, const T& x, long n) {
    return n == 0  ? one
           : n < 0 ? repeated_product(T(one / x), 0UL - static_cast<unsigned long>(n))
                   : repeated_product(x, static_cast<unsigned long>(n));
}

} // namespace edgeproof
