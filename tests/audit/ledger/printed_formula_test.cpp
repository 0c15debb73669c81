// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/audit/ledger/printed_formula.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

TEST_CASE("decimals in a formula, not the dots of names") {
    const auto decimals = [](const char* text) {
        Vocabulary names;
        names.symbols = {"right_c0", "x1", "a"};
        std::vector<PrintedDecimal> found;
        std::string all = to_text(with_names(parse_formula(text, names), text, found));
        for (const PrintedDecimal& d : found) {
            all += " " + d.text;
        }
        return all;
    };
    CHECK(decimals("right.c0*2 + 0.5*x1") == "right_c0*2 + printed_decimal_0*x1 0.5");
    CHECK(decimals("1.5e-3*a + .25/2.") ==
          "printed_decimal_0*a + printed_decimal_1/printed_decimal_2 1.5e-3 .25 2.");
    CHECK(decimals("2e5*a + 0.0") == "200000*a + 0");
    std::vector<PrintedDecimal> found;
    CHECK(with_names(parse_formula("1.5e-3", {}), "1.5e-3", found).kind() == Expr::Kind::symbol);
    CHECK(found.front().unit == Rational(1, 10000));
}
