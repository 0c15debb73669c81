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
/// Nothing if |numerator| exceeds 10^12 or the denominator does not fit into d.
[[nodiscard]] std::optional<SmallFraction> small_fraction(const Rational& q);

/// The built-in functions on the real line. Each throws DomainError, with its name, outside its
/// real domain (log 0, sqrt(-1), asin 2, gamma(-1), atan2(0, 0)), and does not return nan or inf
/// for finite arguments unless the result overflows. sgn(0) = 0, step(0) = 1/2. Accuracy: `Real`
/// results are correctly rounded (MPFR), at the larger of the working precision and those of the
/// arguments; the others have the accuracy of the C library or of Boost.
template <Arithmetic T> [[nodiscard]] T real_call(Builtin f, std::span<const T> x);

/// Returns x^q for an exact exponent: q is not rounded for integers and half-integers; in `Real`
/// any other q has 64 bits more than the result. 0^0 = 1. Throws DomainError for 0 to a negative
/// power and for a negative x to a power that is not an integer.
template <Arithmetic T> [[nodiscard]] T real_power(const T& x, const Rational& q);
template <Arithmetic T> [[nodiscard]] T real_power(const T& x, const T& y);

/// Returns x^n; correctly rounded in `Real`.
template <Arithmetic T> [[nodiscard]] T pow_int(const T& x, long n);

} // namespace edgeproof::formula
