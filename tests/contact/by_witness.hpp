// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/curved/proved_slip.hpp"
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

} // namespace edgeproof::scenes
