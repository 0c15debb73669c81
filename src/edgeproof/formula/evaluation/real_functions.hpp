// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/formula/builtin.hpp"
#include "edgeproof/precision/arithmetic.hpp"

#include <optional>
#include <span>

namespace edgeproof::formula {

/// An exponent of moderate size in lowest terms.
struct SmallFraction {
    long n;
    unsigned long d;
};
/// Nothing if |numerator| is beyond 10^12 or the denominator too long for d.
[[nodiscard]] std::optional<SmallFraction> small_fraction(const Rational& q);

/// The built-in functions on the real line. Each throws DomainError, naming the function, outside
/// its real domain (log 0, sqrt(-1), asin 2, gamma(-1), atan2(0, 0)), and never returns nan or
/// inf for finite arguments unless the result overflows. sgn(0) = 0, step(0) = 1/2.
/// Error: `Real` results are correctly rounded (MPFR), at the larger of the working precision and
/// the arguments' own; the others are those of the C library or of Boost.
template <Arithmetic T> [[nodiscard]] T real_call(Builtin f, std::span<const T> x);

/// x^q with the exponent exact: no rounding of q for integers and half-integers, 64 more bits of
/// it than of the result for other q in `Real`. 0^0 = 1. Throws DomainError for 0 to a negative
/// power and for a negative x to a power that is no integer.
template <Arithmetic T> [[nodiscard]] T real_power(const T& x, const Rational& q);
template <Arithmetic T> [[nodiscard]] T real_power(const T& x, const T& y);

/// x^n; `Real`: correctly rounded.
template <Arithmetic T> [[nodiscard]] T pow_int(const T& x, long n);

} // namespace edgeproof::formula
