// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/symbolic/ginac_bridge.hpp"

#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>
#include <ginac/ginac.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

namespace {

/// Returns the number of factors that are not numbers, with their multiplicity.
long count_of(const GiNaC::ex& product) {
    const auto count = [](const GiNaC::ex& factor) -> long {
        if (GiNaC::is_a<GiNaC::numeric>(factor)) {
            return 0;
        }
        return GiNaC::is_a<GiNaC::power>(factor)
                   ? GiNaC::ex_to<GiNaC::numeric>(factor.op(1)).to_long()
                   : 1;
    };
    if (!GiNaC::is_a<GiNaC::mul>(product)) {
        return count(product);
    }
    long all = 0;
    for (const GiNaC::ex& factor : product) {
        all += count(factor);
    }
    return all;
}

} // namespace

// The products have factors that are linear in a variable of their own, with coprime coefficients,
// and are therefore irreducible. The symbols are new in each round and created in another order:
// the former factorization drew points in an order that depends on this, and did not always
// terminate.
TEST_CASE("products of polynomials in many variables are split into their factors") {
    const auto held = audit::ginac::hold();
    std::mt19937_64 draw(20261123);
    for (int round = 0; round < 200; ++round) {
        std::vector<std::string> names{"a", "b", "b1", "b2", "P1", "P2", "eps"};
        std::shuffle(names.begin(), names.end(), draw);
        std::vector<GiNaC::ex> s;
        for (const std::string& name : names) {
            s.emplace_back(GiNaC::symbol(name));
        }
        GiNaC::ex product = GiNaC::numeric(static_cast<long>(draw() % 30) + 1, 12);
        const long made = 2 + static_cast<long>(draw() % 3);
        for (long k = 0; k < made; ++k) {
            const auto i = static_cast<std::size_t>(k);
            GiNaC::ex factor = s[i] * (s[4] + static_cast<long>(draw() % 5)) + s[5] * s[6];
            factor += static_cast<long>(draw() % 7 + 1) * GiNaC::pow(s[6], 2) + 1;
            product *= factor;
        }
        const GiNaC::ex expanded = product.expand();
        const GiNaC::ex factors = audit::ginac::polynomial_factors(expanded);
        CAPTURE(round);
        CHECK((factors.expand() - expanded).expand().is_zero());
        CHECK(count_of(factors) == made);
    }
}

TEST_CASE("powers, numbers and functions in a polynomial") {
    const auto held = audit::ginac::hold();
    const GiNaC::symbol x("x");
    const GiNaC::symbol y("y");
    const auto factors = [](const GiNaC::ex& e) {
        return audit::ginac::polynomial_factors(e.expand());
    };
    CHECK(factors(GiNaC::numeric(3, 4)).is_equal(GiNaC::numeric(3, 4)));
    CHECK(factors(GiNaC::pow(x + y, 3) * (x - y) / 6).is_equal(GiNaC::pow(x + y, 3) * (x - y) / 6));
    const GiNaC::ex root = GiNaC::sin(x);
    CHECK(count_of(factors(root * root - y * y)) == 2);
    CHECK((factors(root * root - y * y).expand() - (root * root - y * y)).expand().is_zero());
}
