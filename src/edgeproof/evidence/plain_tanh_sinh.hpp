// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/arithmetic.hpp"

#include <boost/math/quadrature/tanh_sinh.hpp>

#include <cstddef>

namespace edgeproof {

/// What Boost.Math's tanh-sinh gives and says of itself.
template <class T> struct PlainIntegral {
    T value{};
    T error{}; ///< absolute
};

/// The integral of f(x) over lo ... hi as the documentation's first example has it: an integrator
/// made on the spot, the integrand of one argument, the tolerance left alone. For comparison: it
/// knows nothing of how near the end points its nodes really are. In `Real` it stops at 9
/// refinements: an integral that has not its 50 digits by then does not get them by the 15th, which
/// takes half a minute.
template <Arithmetic T, class F>
[[nodiscard]] PlainIntegral<T> plain_tanh_sinh(const F& f, const T& lo, const T& hi) {
    constexpr std::size_t refinements = std::same_as<T, Real> ? 9 : 15;
    boost::math::quadrature::tanh_sinh<T> integrator(refinements);
    PlainIntegral<T> result;
    const T tolerance = boost::math::tools::root_epsilon<T>();
    result.value = integrator.integrate(f, lo, hi, tolerance, &result.error);
    return result;
}

} // namespace edgeproof
