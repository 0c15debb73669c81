// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/ledger/printed_formula.hpp"
#include "tests/audit/small_ledger.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

namespace {

// Hertz: P = Pi Es C a^2/4, p(0) = Es C a/2 = sqrt(Es C P/Pi) = 0.5641895835... sqrt(Es C P);
// 1/sqrt(Pi) = 0.56418958354775628694... (DLMF 3.12, erf'(0)/2).
ClaimResult peak(const std::string& says, const std::string& more = "") {
    return small_ledger::result_of("kind = \"value\"\nover = \"nine\"\nwhere = \"m = 1\"\n"
                                   "of = \"p(0)\"\nsays = \"" +
                                   says + "\"\n" + more);
}
std::string peak_verdict(const std::string& says, const std::string& more = "") {
    return std::string(name_of(peak(says, more).outcome.verdict));
}

} // namespace

TEST_CASE("a printed decimal that a constant rounds to: confirmed to its digits, and counted") {
    const ClaimResult three = peak("0.564*sqrt(P*Es*C)");
    CHECK(three.outcome.verdict == Verdict::confirmed);
    CHECK(is_rounded(three.outcome));
    CHECK(three.outcome.note.find("right to the 3 printed digits of 0.564 (exactly 0.56418958") ==
          0);
    for (const char* says : {"0.6*sqrt(P*Es*C)", "0.56*sqrt(P*Es*C)", "0.564190*sqrt(P*Es*C)",
                             "sqrt(0.3183*P*Es*C)", "sqrt(P*Es*C/3.14)", "5.64e-1*sqrt(P*Es*C)",
                             "P^0.5*sqrt(Es*C)*0.5642", "0.5*1.128*sqrt(P*Es*C)"}) {
        CAPTURE(std::string(says));
        CHECK(is_rounded(peak(says).outcome));
    }
    CHECK_FALSE(is_rounded(peak("sqrt(P*Es*C/Pi)").outcome));
    CHECK_FALSE(is_rounded(peak("0.5*Es*C*a").outcome)); // exact as it stands
    CHECK(peak_verdict("0.5*Es*C*a") == "confirmed");
}

TEST_CASE("a printed decimal off by a unit is imprecise, off by more refuted, and corrected") {
    CHECK(peak_verdict("0.565*sqrt(P*Es*C)") == "imprecise");
    CHECK(peak_verdict("0.563*sqrt(P*Es*C)") == "imprecise");
    const ClaimResult wrong = peak("0.546*sqrt(P*Es*C)");
    CHECK(wrong.outcome.verdict == Verdict::refuted);
    CHECK(wrong.outcome.correct.value_or("") == "0.564*sqrt(P*Es*C)");
    CHECK(peak_verdict("0.5642*sqrt(P*Es*C)", "decimals = \"exact\"") == "refuted");
}

TEST_CASE("several decimals in one formula") {
    const auto verdict = [](const std::string& says) {
        return small_ledger::verdict_of(
            "kind = \"value\"\nover = \"nine\"\nof = \"1/Pi + k/sqrt(2)\"\n"
            "vary = { k = [\"1/3\", \"2/7\", \"5\", \"7\", \"1e3\", \"11\"] }\nsays = \"" +
            says + "\"");
    };
    // 1/Pi = 0.31830988..., 1/sqrt(2) = 0.70710678...
    CHECK(verdict("0.318 + 0.7071*k") == "confirmed");
    CHECK(verdict("0.318 + 0.7072*k") == "imprecise");
    CHECK(verdict("0.318 + 0.7171*k") == "refuted");
}

TEST_CASE("a decimal does not save a formula of the wrong form") {
    for (const char* says : {"0.564*sqrt(P*Es*C)*a", "0.564*sqrt(P*Es)*C", "0.564*P*Es*C",
                             "0.564*sqrt(P*Es*C) + 0.001", "0.564*(P*Es*C)^0.4989"}) {
        CAPTURE(std::string(says));
        CHECK(peak_verdict(says) == "refuted");
    }
}

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
