// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/precision/error.hpp"

#include <boost/multiprecision/gmp.hpp>
#include <boost/multiprecision/mpfr.hpp>
#include <cmath>
#include <concepts>

namespace edgeproof {

/// An exact rational number, such as the value of a decimal in a file.
using Rational = boost::multiprecision::number<boost::multiprecision::gmp_rational,
                                               boost::multiprecision::et_off>;
using Integer =
    boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;

/// Returns the exact value of a double. Use no other conversion of a double: the one of the library
/// ends the process for a number that is not finite. Throws DomainError for such a number.
[[nodiscard]] inline Rational exact_rational(double x) {
    if (!std::isfinite(x)) {
        throw DomainError("a number is beyond the range of binary64 arithmetic");
    }
    return Rational(x);
}

/// A floating-point number of any precision, chosen at run time (mpfr2007). Expression templates
/// are off, so that ternary expressions and `auto` have the type Real.
using Real = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<0>,
                                           boost::multiprecision::et_off>;

/// While it exists, new `Real`s of *this thread* have `digits` decimal digits; its destructor
/// restores the former precision. Other threads are not affected: the library changes only
/// thread-local defaults, and every task of a pool opens its own scope. A `Real` from a scope of
/// higher precision keeps its digits (Boost's default rule). Throws DomainError outside 2 ...
/// 100,000,000 digits.
class PrecisionScope {
public:
    explicit PrecisionScope(unsigned digits);
    ~PrecisionScope();
    PrecisionScope(const PrecisionScope&) = delete;
    PrecisionScope& operator=(const PrecisionScope&) = delete;

private:
    unsigned saved_digits_;
};

/// Returns the number of decimal digits of a new `Real` of this thread.
[[nodiscard]] unsigned working_digits();

/// Returns x rounded to the working precision of this thread.
[[nodiscard]] Real at_working_precision(const Real& x);

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
