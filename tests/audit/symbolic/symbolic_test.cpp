// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/audit/ledger/claim.hpp"
#include "edgeproof/audit/ledger/ledger_parts.hpp"
#include "edgeproof/audit/symbolic/symbolic.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

// The table claims/symbols.txt has identities and expansions.
TEST_CASE("derived formulas are written out, the same on every run") {
    const auto derived = [](const std::string& text) {
        Vocabulary names;
        names.symbols = scene_names();
        return to_text(derive(parse_formula(text, names), {}));
    };
    CHECK(derived("right.c0") == "2*P1/(Pi*sqrt(a + b))");
    CHECK(derived("right.c1") == "((2*b1 + 3)*P1 - 4*(a + b)*P2)/(3*Pi*(a + b)^(3/2))");
    CHECK(derived("1/(a-b)-1/(b-a)") == "2/(a - b)");
}
