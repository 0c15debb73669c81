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

TEST_CASE("a rigid flat punch: its pressure is the traction q(x) of a force Q under full stick") {
    // p = P/(pi sqrt(a^2 - x^2)) for the force P (Johnson, eq. 2.64), with Q as that force.
    const std::string punch = small_ledger::head + R"(
[[family]]
name = "flat-punch"
profile = "power-law"
count = 4
u = ["1e-9", "1/20", "1/3"]
[family.parameters]
m = ["1"]
C = ["1"]
Es = ["1"]
a = ["3/2", "0.02"]
Q = ["7/5", "2e4"]
sig0 = ["0"]
)";
    const auto verdict = [&](const char* says) {
        const Ledger ledger = small_ledger::ledger_of(
            std::string("kind = \"value\"\nof = \"q(x)\"\nover = \"flat-punch\"\nsays = '") + says +
                "'\n",
            punch);
        return small_ledger::audit_of(ledger).claims.front().outcome.verdict;
    };
    CHECK(verdict(R"(\frac{Q}{\pi\sqrt{a^2-x^2}})") == Verdict::confirmed);
    CHECK(verdict("Q/(Pi*sqrt(u*(2*a - u)))") == Verdict::confirmed);
    CHECK(verdict(R"(\frac{Q}{2\sqrt{a^2-x^2}})") == Verdict::refuted);
}
