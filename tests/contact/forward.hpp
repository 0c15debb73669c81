// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/law/kernels.hpp"
#include "edgeproof/contact/witness/edge_equations.hpp"
#include "edgeproof/quadrature/tanh_sinh.hpp"

/// Puts a traction back into the equations that it must satisfy: its resultant and its principal
/// value (docs/pressure.md, "The forward check"). The traction q is a function of a Place. It is
/// evaluated anew at every node, and only needs to be integrable at the edges and smooth in
/// between.
namespace edgeproof::contact {

using witness::Place;

/// The integral of q over the contact, in the unit of q times length. The quadrature stops at
/// `target_digits` (0: at roundoff).
template <class Q>
[[nodiscard]] auto resultant(const Extent<Real>& e, const Q& q, unsigned target_digits) {
    const Real half = e.length() / 2;
    const auto halves = [&](bool at_right) {
        return quadrature::integrate_near(
            [&](const Real& lo, const Real& hi) {
                const Real far = half + hi;
                return Real(
                    q(at_right ? Place{lo, far, Real(e.a - lo)} : Place{far, lo, Real(lo - e.b)}));
            },
            half, Real(0), Real(0), {.target_digits = target_digits});
    };
    auto sum = halves(true);
    sum.add(halves(false));
    return sum;
}

/// PV of q(s)/(s - x) ds over the contact, in the unit of q. Up to half the distance to the nearer
/// edge the integral runs over the pairs (q(x+y) - q(x-y))/y, which are not singular; the rest is
/// regular.
template <class Q>
[[nodiscard]] auto principal_value(const Extent<Real>& e, const Place& at, const Q& q,
                                   unsigned target_digits) {
    const Real inner = (at.right < at.left ? at.right : at.left) / 2;
    const quadrature::QuadratureOptions options{.target_digits = target_digits};
    auto sum = quadrature::integrate_near(
        [&](const Real& y, const Real&) {
            const Place after{Real(at.right - y), Real(at.left + y), Real(at.x + y)};
            const Place before{Real(at.right + y), Real(at.left - y), Real(at.x - y)};
            return Real((q(after) - q(before)) / y);
        },
        inner, Real(0), Real(0), options);
    const Real right = at.right - inner;
    sum.add(quadrature::integrate_near(
        [&](const Real& lo, const Real& hi) {
            const Place s{hi, Real(e.length() - hi), Real(e.a - hi)};
            return Real(q(s) / (inner + lo));
        },
        right, inner, Real(0), options));
    const Real left = at.left - inner;
    sum.add(quadrature::integrate_near(
        [&](const Real& lo, const Real& hi) {
            const Place s{Real(e.length() - lo), lo, Real(lo - e.b)};
            return Real(-q(s) / (inner + hi));
        },
        left, Real(0), inner, options));
    return sum;
}

} // namespace edgeproof::contact
