// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/audit/small_ledger.hpp"

#include <doctest/doctest.h>

namespace {

/// A claim about Hertz's contact, judged.
ClaimResult judged_typed(const std::string& says, const std::string& of = "p(x)") {
    return small_ledger::result_of("kind = \"value\"\nsays = '" + says + "'\nof = \"" + of +
                                   "\"\nover = \"hertz\"\n");
}

} // namespace

TEST_CASE("a claim in LaTeX is judged by its reading, which it states") {
    // p = Es C/2 sqrt(a^2 - x^2), and P is its integral (Johnson, eqs 4.43 and 4.45).
    const ClaimResult right = judged_typed(R"(\frac{E^{*}C}{2}\sqrt{a^{2}-x^{2}})");
    CHECK(right.outcome.verdict == Verdict::confirmed);
    REQUIRE(right.claim.typed("says") != nullptr);
    CHECK(*right.claim.typed("says") == R"(\frac{E^{*}C}{2}\sqrt{a^{2}-x^{2}})");
    CHECK(right.claim.text("says") == "Es*C/2*sqrt(a^2-x^2)");
    const ClaimResult wrong = judged_typed(R"(\frac{E^{*}C}{3}\sqrt{a^{2}-x^{2}})");
    CHECK(wrong.outcome.verdict == Verdict::refuted);
    CHECK(wrong.outcome.correct == "Es*C/2*sqrt(a^2 - x^2)");
    CHECK(judged_typed(R"(\int_{-a}^{a}\frac{E^*C}{2}\sqrt{a^2-s^2}\,ds)", "P").outcome.verdict ==
          Verdict::confirmed);
}

TEST_CASE("a claim without the signs of products is judged by its reading, decimals included") {
    // 2 P/(pi a) is the largest pressure; 2/pi = 0.63661...
    const ClaimResult exact = judged_typed("2P sqrt((a - x)(a + x))/(pi a^2)");
    CHECK(exact.outcome.verdict == Verdict::confirmed);
    CHECK(exact.claim.text("says") == "2*P*sqrt((a - x)*(a + x))/(pi*a^2)");
    const ClaimResult rounded = judged_typed("0.64P sqrt(a^2 - x^2)/a^2");
    CHECK(rounded.outcome.verdict == Verdict::confirmed);
    CHECK(is_rounded(rounded.outcome));
    CHECK(judged_typed("0.62P sqrt(a^2 - x^2)/a^2").outcome.verdict == Verdict::refuted);
    CHECK(judged_typed("Es*C/2*sqrt(a^2 - x^2)").claim.typed("says") == nullptr);
    const ClaimResult decades = judged_typed("Es C/2*sqrt(a^2 - x^2)*log10(10)*exp(ln(2))/2");
    CHECK(decades.outcome.verdict == Verdict::confirmed);
}

TEST_CASE("a claim that can be read in two ways is refused with its line") {
    for (const char* says : {"Es C/2 sqrt(a^2 - x^2)", R"(\sin 2x)", R"(P(a))", R"(\foo{x})"}) {
        const Ledger ledger =
            parse_ledger(small_ledger::head + "[[claim]]\nid = \"C\"\nkind = \"value\"\nsays = '" +
                             says + "'\nof = \"p(x)\"\nover = \"hertz\"\n",
                         "typed.toml", ClaimErrors::kept);
        CAPTURE(says);
        REQUIRE(ledger.errors.size() == 1);
        CHECK(ledger.claims.empty());
    }
}
