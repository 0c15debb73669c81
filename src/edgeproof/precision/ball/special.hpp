// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/arithmetic.hpp"
#include "edgeproof/precision/bounded_cache.hpp"

#include <boost/math/special_functions/beta.hpp>

#include <memory>
#include <utility>

namespace edgeproof {

/// The integral of sin^n over 0 ... pi/2, n > -1: B((n+1)/2, 1/2)/2 (DLMF 5.12.2).
template <Arithmetic T> [[nodiscard]] T sine_power_integral(const T& n) {
    if constexpr (std::same_as<T, Real>) {
        // Many contacts have the same exponent, and the gamma function is the most expensive part
        // of each.
        thread_local BoundedCache<std::pair<Real, unsigned>, const Real> known(256);
        return *known.get({n, working_digits()}, [&] {
            // MPFR's gamma function is correctly rounded at any precision; Boost's is not.
            Real half_up = (n + 1) / 2;
            Real whole = half_up + Real(1) / 2;
            Real numerator;
            Real denominator;
            // B(x, 1/2) = sqrt(pi) Gamma(x)/Gamma(x + 1/2) (DLMF 5.12.1)
            mpfr_lngamma(numerator.backend().data(), half_up.backend().data(), MPFR_RNDN);
            mpfr_lngamma(denominator.backend().data(), whole.backend().data(), MPFR_RNDN);
            return std::make_shared<const Real>(sqrt(pi<Real>()) / 2 *
                                                exp(numerator - denominator));
        });
    } else {
        return boost::math::beta(T((n + T(1)) / T(2)), T(T(1) / T(2))) / T(2);
    }
}

} // namespace edgeproof
