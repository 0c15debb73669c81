// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/rational.hpp"
#include "edgeproof/precision/real.hpp"

#include <boost/math/constants/constants.hpp>

#include <cfloat>
#include <cmath>
#include <concepts>
#include <limits>
#include <type_traits>

#if LDBL_MANT_DIG != 113
#include <boost/multiprecision/float128.hpp>
#endif

namespace edgeproof {

/// binary128: a type of libquadmath, except where long double has this format (WebAssembly, ARM).
#if LDBL_MANT_DIG == 113
using Float128 = long double;
#define EDGEPROOF_FOR_EACH_ARITHMETIC(M) M(double) M(long double) M(Real)
#else
using Float128 = boost::multiprecision::float128;
#define EDGEPROOF_FOR_EACH_ARITHMETIC(M) M(double) M(long double) M(Float128) M(Real)
#endif
// The number types for which every numerical route is compiled, once, in its own source file: a
// file that includes the header does not compile the quadrature again.

/// The number types for which all numerical routes are compiled from the same templates: binary64,
/// the extended format of the machine, binary128, and arbitrary precision.
template <class T>
concept Arithmetic = std::same_as<T, double> || std::same_as<T, long double> ||
    std::same_as<T, Float128> || std::same_as<T, Real>;

/// Returns the number nearest to q in T (`Real`: at the working precision). There is one rounding
/// for `Real`, and two for the other types.
template <Arithmetic T> [[nodiscard]] T from_rational(const Rational& q) {
    if constexpr (std::same_as<T, Real>) {
        Real x;
        mpfr_set_q(x.backend().data(), q.backend().data(), MPFR_RNDN);
        return x;
    } else {
        // 40 digits are more than any format below Real has, so that the second rounding is correct
        // except in a vanishing fraction of cases, where the result is within one unit in the last
        // place.
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
