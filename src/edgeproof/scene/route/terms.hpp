// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/ball/ball.hpp"
#include "edgeproof/precision/ball/magnitude.hpp"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <vector>

namespace edgeproof::scene {

/// The sum of the first n terms of an expansion at the distance u from its edge, by Horner's rule.
/// The first term is c_0 sqrt(u), or c_0/sqrt(u) if it is `singular`. `value` returns the number in
/// an element of `c`.
template <class T, class C, class Value = std::identity>
[[nodiscard]] T sum_of_terms(const C& c, std::size_t n, const T& u, bool singular,
                             const Value& value = {}) {
    T total = std::invoke(value, c[n - 1]);
    for (std::size_t k = n - 1; k-- > 0;) {
        total = total * u + std::invoke(value, c[k]);
    }
    return singular ? T(total / sqrt(u)) : T(total * sqrt(u));
}

/// A power series in u whose coefficients are enclosed, with |c_k| <= most/radius^k for all k.
struct BoundedSeries {
    std::function<std::vector<Ball>(std::size_t)> coefficients; ///< the first n coefficients
    Ball most;
    Ball radius;
};

/// Returns the sum of c_k u^k over all k >= n, without a difference of nearly equal numbers: enough
/// terms for the bits of u, and a bound of the others. The result is not finite unless u is less
/// than a 16th of the radius.
[[nodiscard]] inline Ball omitted_terms(const BoundedSeries& series, std::size_t n, const Ball& u) {
    const long bits = u.bits();
    const Ball part = u / series.radius;
    const Ball limit(Rational(1, 16), bits);
    if (!series.most.is_finite() || !part.is_finite() || !certainly_less(abs(part), limit)) {
        Ball unknown(0, bits);
        arb_indeterminate(unknown.data());
        return unknown;
    }
    // Each term is at most a 16th of the term before.
    const std::size_t smallness = static_cast<std::size_t>(
        std::max<slong>(4, -arf_abs_bound_lt_2exp_si(arb_midref(part.data()))));
    const std::size_t count = n + static_cast<std::size_t>(bits) / smallness + 2;
    const std::vector<Ball> c = series.coefficients(count);
    Ball sum =
        Magnitude(series.most * pow_int(part, static_cast<long>(count)) / (1 - part)).ball(bits);
    for (std::size_t k = count; k-- > n;) {
        sum += c[k] * pow_int(u, static_cast<long>(k));
    }
    return sum;
}

} // namespace edgeproof::scene
