// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/ledger/printed_formula.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

TEST_CASE("decimals in a formula, not the dots of names") {
    const auto texts = [](const char* formula) {
        std::string all;
        for (const PrintedDecimal& d : printed_decimals(formula)) {
            all += d.text + " ";
        }
        return all;
    };
    CHECK(texts("right.c0*2 + 0.5*x1.25") == "0.5 ");
    CHECK(texts("1.5e-3*a + .25/2.") == "1.5e-3 .25 2. ");
    CHECK(texts("2e5*a") == "");
    CHECK(printed_decimals("1.5e-3").front().unit == Rational(1, 10000));
}
