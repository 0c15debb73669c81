// SPDX-License-Identifier: BSD-3-Clause
#include "tests/contact/scenes.hpp"

#include "edgeproof/contact/curved/proved_slip.hpp"
#include "edgeproof/contact/profile/slope.hpp"
#include "edgeproof/contact/witness/edge_equations.hpp"
#include "edgeproof/quadrature/tanh_sinh.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <memory>

using namespace edgeproof::scenes;
using edgeproof::contact::witness::Place;

namespace {

constexpr long forward_bits = 200;

/// Integrals of a pressure over its contact, with the pressure computed at every node: from p back
/// to the data from which it was computed.
struct Forward {
    RealSlope slope;
    std::unique_ptr<ProvedContact> contact;
    Extent<Real> e;

    explicit Forward(const Contact& c)
        : slope(c.profile), contact(proved_contact(c.profile, c.modulus, c.load, forward_bits)),
          e{at_working_precision(contact->a().midpoint()),
            at_working_precision(contact->b().midpoint())} {}

    [[nodiscard]] Real pressure(const Place& at) const {
        const bool right = at.right < at.left;
        return contact
            ->pressure(right ? Edge::right : Edge::left,
                       Ball(right ? at.right : at.left, forward_bits))
            .midpoint();
    }
    /// Returns the integral of f(point) over the contact, split at the knots and at `also` (a
    /// distance from -b).
    template <class F> [[nodiscard]] Real integrate(const F& f, const Real& also = Real(0)) const {
        std::vector<Real> left{Real(0)};
        for (const Real& knot : slope.knots()) {
            if (knot < e.a && -knot < e.b) {
                left.push_back(Real(e.b + knot));
            }
        }
        if (also > 0) {
            left.push_back(also);
        }
        left.push_back(e.length());
        std::sort(left.begin(), left.end());
        std::vector<Real> lengths;
        for (std::size_t i = 0; i + 1 < left.size(); ++i) {
            lengths.push_back(left[i + 1] - left[i]);
        }
        const auto at = [&](std::size_t i, const Real& lo, const Real& hi) {
            const Real from_left = left[i] + lo;
            const Real from_right = e.length() - left[i + 1] + hi;
            const Place point{from_right, from_left,
                              from_left < from_right ? Real(from_left - e.b)
                                                     : Real(e.a - from_right)};
            // Nearer to a cut the point rounds onto it; p grows there at most like a logarithm, and
            // the weight of the omitted part is 1e-45.
            return (lo < hi ? lo : hi) < e.length() * Real("1e-45") ? Real(0)
                                                                    : Real(f(i, lo, hi, point));
        };
        const auto r = integrate_pieces(at, lengths, Real(0), Real(0), {.target_digits = 22});
        REQUIRE(r.converged);
        return r.value;
    }
};

/// Checks g'(x) = (2/(pi E*)) PV of p(s)/(x - s) ds (Barber, Contact Mechanics, the normal
/// displacement of two half-planes), made regular by subtracting p(x).
void check(const Contact& c) {
    CAPTURE(c.name);
    const PrecisionScope scope(50);
    const Forward forward(c);
    const Extent<Real>& e = forward.e;
    const Real P = forward.integrate([&](std::size_t, const Real&, const Real&, const Place& at) {
        return forward.pressure(at);
    });
    CHECK(common_digits(P, forward.contact->force().midpoint()) >= 20);
    if (!c.profile.symmetric()) {
        const Real M =
            forward.integrate([&](std::size_t, const Real&, const Real&, const Place& at) {
                return Real(at.x * forward.pressure(at));
            });
        CHECK(common_digits(M, forward.contact->moment().midpoint()) >= 19);
    }
    for (const char* fraction : {"0.17", "0.61", "0.93"}) {
        const Real left = e.length() * Real(fraction);
        const Place x{Real(e.length() - left), left, Real(left - e.b)};
        const Real at_x = forward.pressure(x);
        const Real regular = forward.integrate(
            [&](std::size_t, const Real&, const Real&, const Place& s) {
                // The distance from x loses its digits only where the weight of the quotient is as
                // small.
                const Real d = x.left - s.left;
                return d == 0 ? Real(0) : Real((forward.pressure(s) - at_x) / d);
            },
            left);
        const Real found =
            2 / (pi<Real>() * c.modulus.to<Real>()) * (regular + at_x * log(x.left / x.right));
        const Real expected = forward.slope.value(forward.slope.piece_at(x.x), x.x);
        const Real size = abs(forward.slope.value(forward.slope.pieces().size() - 1, e.a));
        CHECK(abs(found - expected) < size * Real("1e-18"));
    }
}

} // namespace

TEST_CASE("the pressure in the integral equation gives g', P and M again") {
    const auto s = symmetric();
    check(s[0]);
    check(s[6]);
    check(s[8]);
    for (const Contact& c : tilted()) {
        check(c);
    }
}

TEST_SUITE_BEGIN("slow");
TEST_CASE("the pressure gives g', P and M again where it is itself a quadrature") {
    check(symmetric()[2]);
    check(own_symmetric());
}
TEST_SUITE_END();
