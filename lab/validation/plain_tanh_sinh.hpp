// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/arithmetic.hpp"
#include "edgeproof/precision/error.hpp"

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/math/special_functions/next.hpp>

#include <cmath>
#include <cstddef>

namespace edgeproof::validation {

/// The result of Boost.Math's tanh-sinh and its error estimate.
template <class T> struct PlainIntegral {
    T value{};
    T error{}; ///< absolute
};

/// Integrates f(x) over lo ... hi as in the first example of Boost's documentation: a new
/// integrator, an integrand of one argument, the default tolerance. It is used for comparison only:
/// it does not know the exact distances of its nodes from the end points. In `Real` it stops at 9
/// refinements: an integral without 50 digits by then does not reach them by the 15th, which takes
/// half a minute.
///
/// Throws DomainError if the interval is so few units of the last place wide that the first nodes
/// next to the middle coincide with its ends: Boost 1.81 then reads before the first entry of its
/// table of nodes.
template <Arithmetic T, class F>
[[nodiscard]] PlainIntegral<T> plain_tanh_sinh(const F& f, const T& lo, const T& hi) {
    using std::abs;
    constexpr std::size_t refinements = std::same_as<T, Real> ? 9 : 15;
    boost::math::quadrature::tanh_sinh<T> integrator(refinements);
    PlainIntegral<T> result;
    // 1 - tanh(pi/2 sinh 1), rounded down: the node at t = 1, the first of the coarsest row.
    constexpr double first_node = 0.0486;
    const T half = (hi - lo) / T(2);
    const auto unit_at = [&](const T& end) { // Boost's least distance from an end
        const T x = abs(end / half);
        return T(boost::math::float_next(x) - x);
    };
    if (lo < hi && (unit_at(lo) >= T(first_node) || unit_at(hi) >= T(first_node))) {
        throw DomainError("the interval is too short for plain tanh-sinh at this precision");
    }
    const T tolerance = boost::math::tools::root_epsilon<T>();
    result.value = integrator.integrate(f, lo, hi, tolerance, &result.error);
    return result;
}

} // namespace edgeproof::validation
