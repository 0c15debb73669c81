// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/rational.hpp"
#include "edgeproof/precision/real.hpp"

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/float128.hpp>

#include <cmath>
#include <concepts>
#include <limits>
#include <type_traits>

namespace edgeproof {

using Float128 = boost::multiprecision::float128;

/// The arithmetics that the numerical routes run in, all through the same code: binary64, the
/// machine's extended format, binary128, and any precision at all.
template <class T>
concept Arithmetic = std::same_as<T, double> || std::same_as<T, long double> ||
    std::same_as<T, Float128> || std::same_as<T, Real>;

/// The number nearest to q in T (`Real`: at the working precision), with one rounding, or two for
/// T other than `Real`.
template <Arithmetic T> [[nodiscard]] T from_rational(const Rational& q) {
    if constexpr (std::same_as<T, Real>) {
        Real x;
        mpfr_set_q(x.backend().data(), q.backend().data(), MPFR_RNDN);
        return x;
    } else {
        // 40 digits hold every format below Real and more, so that a second rounding is right in
        // all but a vanishing fraction of cases; the result is then still within one ulp.
        Real x(0, 40U);
        mpfr_set_q(x.backend().data(), q.backend().data(), MPFR_RNDN);
        return x.convert_to<T>();
    }
}

/// pi in T (`Real`: at the working precision).
template <Arithmetic T> [[nodiscard]] T pi() {
    if constexpr (std::same_as<T, Real>) {
        Real x;
        mpfr_const_pi(x.backend().data(), MPFR_RNDN);
        return x;
    } else {
        return boost::math::constants::pi<T>();
    }
}

/// The spacing of T at 1 (`Real`: at the working precision).
template <Arithmetic T> [[nodiscard]] T unit_roundoff() {
    if constexpr (std::same_as<T, Real>) {
        Real one(1);
        const mpfr_prec_t bits = mpfr_get_prec(one.backend().data());
        return ldexp(one, static_cast<int>(1 - bits));
    } else {
        return std::numeric_limits<T>::epsilon();
    }
}

/// The decimal digits that T carries (`Real`: the working precision).
template <Arithmetic T> [[nodiscard]] unsigned digits_of() {
    if constexpr (std::same_as<T, Real>) {
        return working_digits();
    } else {
        return static_cast<unsigned>(std::numeric_limits<T>::digits10);
    }
}

} // namespace edgeproof
