// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/formula/parse.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

namespace {

FormulaError refusal(const std::string& text, const Symbols& symbols) {
    try {
        (void)parse(text, symbols);
    } catch (const FormulaError& error) {
        return error;
    }
    FAIL("accepted: " << text);
    return {"", "", 0};
}

} // namespace

TEST_CASE("a number with a unit is refused: numbers have no units") {
    for (const char* text :
         {"70 GPa", "70GPa", "1e3 Pa", "0.5mm", "2.5e-3 m", "(70 GPa)/2", "3 N/mm^2", "1 kN"}) {
        CAPTURE(text);
        CHECK(refusal(text, {}).problem().find("numbers have no units here: '") == 0);
        CHECK(refusal(text, {}).instead().find("write the number alone") == 0);
    }
    CHECK(refusal("70*GPa", Symbols{"a"}).instead().find("numbers have no units here") == 0);
    CHECK(refusal("70 GPa*a", Symbols{"a"}).problem().find("numbers have no units here") == 0);
    // These may be products.
    for (const char* text : {"2pi", "2 sqrt(2)", "2Pi/3"}) {
        CHECK(refusal(text, {}).problem().find("a '*' is missing") == 0);
    }
    for (const char* text : {"2x", "2 y", "3 gamma(x)"}) {
        CHECK(refusal(text, Symbols{"x"}).problem().find("a '*' is missing") == 0);
    }
}

TEST_CASE("a misspelled name in a formula: the near name is suggested") {
    const Symbols symbols{"alpha", "gam", "x"};
    const auto instead = [&](const char* text) { return refusal(text, symbols).instead(); };
    CHECK(instead("alhpa*x").find("did you mean alpha? use one of: ") == 0);
    CHECK(instead("X").find("did you mean x? ") == 0);
    CHECK(instead("sqr(x)").find("did you mean sqrt? ") == 0);
    CHECK(instead("atanh2(x)").find("did you mean atan") == 0);
    CHECK(instead("unrelated").find("use one of: ") == 0);
    CHECK(instead("arcsin(x)") == "write asin(...)");
}
