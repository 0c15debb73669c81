// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/precision/rational.hpp"
#include "edgeproof/precision/real.hpp"

#include <concepts>

namespace edgeproof {

/// The number types of templates that are compiled once, in a source file: binary64, for starting
/// values, and arbitrary precision.
template <class T>
concept Arithmetic = std::same_as<T, double> || std::same_as<T, Real>;
#define EDGEPROOF_FOR_EACH_ARITHMETIC(M) M(double) M(Real)

/// Returns the number nearest to q at the working precision.
template <std::same_as<Real> T> [[nodiscard]] T from_rational(const Rational& q) {
    Real x;
    mpfr_set_q(x.backend().data(), q.backend().data(), MPFR_RNDN);
    return x;
}

/// Returns pi at the working precision.
template <std::same_as<Real> T> [[nodiscard]] T pi() {
    Real x;
    mpfr_const_pi(x.backend().data(), MPFR_RNDN);
    return x;
}

/// Returns the distance from 1 to the next larger number at the working precision.
template <std::same_as<Real> T> [[nodiscard]] T unit_roundoff() {
    Real one(1);
    const mpfr_prec_t bits = mpfr_get_prec(one.backend().data());
    return ldexp(one, static_cast<int>(1 - bits));
}

} // namespace edgeproof
