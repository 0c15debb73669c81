// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/law/kernels.hpp"
#include "edgeproof/quadrature/near_singularity.hpp"

/// Puts a traction back into the equations that it must satisfy: its resultant and its principal
/// value (docs/pressure.md, "The forward check"). The traction q is a function of a Point. It is
/// evaluated anew at every node, and only needs to be integrable at the edges and smooth in
/// between.
namespace edgeproof::contact {

/// The integral of q over the contact, in the unit of q times length. The quadrature stops at
/// `target_digits` (0: at roundoff).
template <Arithmetic T, class Q>
[[nodiscard]] auto resultant(const Extent<T>& e, const Q& q, unsigned target_digits) {
    const T half = e.length() / T(2);
    const auto halves = [&](bool at_right) {
        return quadrature::integrate_one_sided<T>(
            [&](const T& lo, const T& hi) {
                const T far = half + hi;
                return T(
                    q(at_right ? Point<T>{lo, far, T(e.a - lo)} : Point<T>{far, lo, T(lo - e.b)}));
            },
            half, T(0), true, {.target_digits = target_digits});
    };
    auto sum = halves(true);
    sum.add(halves(false));
    return sum;
}

/// PV of q(s)/(s - x) ds over the contact, in the unit of q. Up to half the distance to the nearer
/// edge the integral runs over the pairs (q(x+y) - q(x-y))/y, which are not singular; the rest is
/// regular.
template <Arithmetic T, class Q>
[[nodiscard]] auto principal_value(const Extent<T>& e, const Point<T>& at, const Q& q,
                                   unsigned target_digits) {
    const T inner = (at.right < at.left ? at.right : at.left) / T(2);
    const quadrature::QuadratureOptions options{.target_digits = target_digits};
    auto sum = quadrature::integrate_one_sided<T>(
        [&](const T& y, const T&) {
            const Point<T> after{T(at.right - y), T(at.left + y), T(at.x + y)};
            const Point<T> before{T(at.right + y), T(at.left - y), T(at.x - y)};
            return T((q(after) - q(before)) / y);
        },
        inner, T(0), true, options);
    const T right = at.right - inner;
    sum.add(integrate_near<T>(
        [&](const T& lo, const T& hi) {
            const Point<T> s{hi, T(e.length() - hi), T(e.a - hi)};
            return T(q(s) / (inner + lo));
        },
        right, inner, T(0), options));
    const T left = at.left - inner;
    sum.add(integrate_near<T>(
        [&](const T& lo, const T& hi) {
            const Point<T> s{T(e.length() - lo), lo, T(lo - e.b)};
            return T(-q(s) / (inner + hi));
        },
        left, T(0), inner, options));
    return sum;
}

} // namespace edgeproof::contact
