// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/contact/curved/proved_slip.hpp"
#include "edgeproof/contact/enclosure/ball_values.hpp"
#include "tests/contact/scenes.hpp"

#include <doctest/doctest.h>

/// Contacts by the witness, compared with enclosures.
namespace edgeproof::scenes {

inline Witness witness_of(const Contact& c, unsigned digits) {
    return {c.profile, c.modulus, c.load, digits};
}

/// The digits that the edges, the loads and the pressures of the witness share with enclosures; the
/// pressures by `route` at `places`, parts of the contact's length from the right edge.
inline int digits_shared(const Contact& c, unsigned digits, Route route,
                         const std::vector<const char*>& places) {
    const Witness witness = witness_of(c, digits);
    const long bits = static_cast<long>(4 * digits) + (digits < 20 ? 100 : 400);
    const auto balls = proved_contact(c.profile, c.modulus, c.load, bits);
    const PrecisionScope scope(digits + 20);
    int least = std::min({common_digits(witness.a(), balls->a().midpoint()),
                          common_digits(witness.b(), balls->b().midpoint()),
                          common_digits(witness.force(), balls->force().midpoint())});
    const Real size = witness.force() * (witness.a() + witness.b());
    const Real moment = witness.moment() - balls->moment().midpoint();
    least = std::min(least, common_digits(Real(size + moment), size));
    for (const char* place : places) {
        const Exact u = Exact::parse(Real((witness.a() + witness.b()) * Real(place)).str(12));
        for (const Edge edge : {Edge::right, Edge::left}) {
            const Ball p = balls->pressure(edge, u);
            REQUIRE(p.relative_accuracy_bits() > static_cast<long>(3.4 * digits));
            const int shared = common_digits(witness.pressure(edge, u, route).value, p.midpoint());
            CAPTURE(place);
            CHECK(shared >= static_cast<int>(digits));
            least = std::min(least, shared);
        }
    }
    return least;
}

/// Checks the first coefficients c_k of `balls` at an edge by a pressure of the witness at the part
/// 10^-decades of their reach, to `decades` digits less 4 of the last one.
inline void check_coefficients(const Contact& c, const ProvedContact& balls, Edge edge,
                               std::size_t terms, int decades) {
    const int digits = decades * static_cast<int>(terms);
    const Ball part = enclosed_constant(Exact::parse("1e-" + std::to_string(decades)), 64);
    const Rational u = exact_value((balls.reach(edge) * part).with_bits(20).midpoint());
    const Real p = witness_of(c, static_cast<unsigned>(digits))
                       .pressure(edge, Exact::of(u), Route::singular_integral)
                       .value;
    const Ball at(u, 4L * digits + 60);
    const PrecisionScope scope(static_cast<unsigned>(digits) + 20);
    const Ball sum = horner(balls.expansion(edge, terms), at) * sqrt(at);
    CHECK(common_digits(p, sum.midpoint()) >= digits - 4);
}

} // namespace edgeproof::scenes
