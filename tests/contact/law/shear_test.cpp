// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/contact/law/shear.hpp"
#include "edgeproof/contact/witness/edge_equations.hpp"
#include "edgeproof/quadrature/tanh_sinh.hpp"
#include "tests/contact/scenes.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

using scenes::all_signs;
using scenes::exact;
using scenes::ShearCase;
using witness::Place;

namespace {

// A traction q is put back into the equations that it must satisfy (docs/pressure.md, "The forward
// check"). It is a function of a Place, evaluated anew at every node, and only needs to be
// integrable at the edges and smooth in between.

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

} // namespace

TEST_CASE("full stick: the integral equation gives the tension, the resultant gives Q") {
    const PrecisionScope scope(50);
    for (const Extent<Real>& e :
         {Extent<Real>{Real(3) / 2, Real(3) / 2}, Extent<Real>{Real(7) / 3, Real(1) / 5},
          Extent<Real>{Real("1e-6"), Real(40)}}) {
        for (const ShearCase& c : all_signs) {
            const ShearLoad<Real> load{exact(c.Q).to<Real>(), exact(c.sigma).to<Real>()};
            const auto q = [&](const Place& at) {
                return full_stick_traction(at.right, at.left, load);
            };
            CAPTURE(c.Q);
            CAPTURE(c.sigma);
            // Relative to the size of the integrand, because the tension's own resultant is zero.
            const Real size = abs(load.Q) + abs(load.bulk_tension) * e.length();
            const auto Q = resultant(e, q, 40);
            REQUIRE(Q.converged);
            CHECK(abs(Real(Q.value - load.Q)) < size * Real("1e-38"));
            for (const char* fraction : {"1e-3", "0.2", "0.5", "0.77", "0.999"}) {
                const Real u = exact(fraction).to<Real>() * e.length();
                const Place at{u, Real(e.length() - u), Real(e.a - u)};
                const auto strain = principal_value(e, at, q, 34);
                REQUIRE(strain.converged);
                const Real expected = pi<Real>() * load.bulk_tension / 4;
                const Real around = size / sqrt(Real(at.right * at.left)) *
                                    (e.length() / (at.right < at.left ? at.right : at.left));
                CHECK(abs(Real(strain.value - expected)) < around * Real("1e-31"));
            }
        }
    }
}
