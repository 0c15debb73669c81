// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/arithmetic.hpp"
#include "edgeproof/precision/error.hpp"

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/math/special_functions/next.hpp>

#include <cmath>
#include <cstddef>

namespace edgeproof::validation {

/// What Boost.Math's tanh-sinh gives and says of itself.
template <class T> struct PlainIntegral {
    T value{};
    T error{}; ///< absolute
};

/// The integral of f(x) over lo ... hi as the documentation's first example has it: an integrator
/// made on the sample, the integrand of one argument, the tolerance left alone. For comparison: it
/// knows nothing of how near the end points its nodes really are. In `Real` it stops at 9
/// refinements: an integral that has not its 50 digits by then does not get them by the 15th, which
/// takes half a minute.
///
/// Throws DomainError where the interval is so few units of the last place wide that the first
/// nodes beside the middle cannot be told from its ends: Boost 1.81 then steps back past the first
/// entry of its table of nodes, and reads what is not there.
template <Arithmetic T, class F>
[[nodiscard]] PlainIntegral<T> plain_tanh_sinh(const F& f, const T& lo, const T& hi) {
    using std::abs;
    constexpr std::size_t refinements = std::same_as<T, Real> ? 9 : 15;
    boost::math::quadrature::tanh_sinh<T> integrator(refinements);
    PlainIntegral<T> result;
    // 1 - tanh(pi/2 sinh 1), rounded down: the node at t = 1, the first of the coarsest row.
    constexpr double first_node = 0.0486;
    const T half = (hi - lo) / T(2);
    const auto unit_at = [&](const T& end) { // what Boost takes for the least distance from an end
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
