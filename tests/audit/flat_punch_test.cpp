// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/precision/error.hpp"
#include "tests/audit/small_ledger.hpp"

#include <doctest/doctest.h>

namespace {

using namespace small_ledger;

const std::string punches = R"(
[ledger]
name = "punches"
[[family]]
name = "punch"
profile = "flat-punch"
count = 4
u = ["1e-9", "1/20", "1/3"]
[family.parameters]
a = ["3/2", "0.02"]
P = ["7/5", "2e4"]
)";

Outcome judged(const std::string& kind, const std::string& of, const std::string& says) {
    const Ledger ledger = ledger_of("kind = \"" + kind + "\"\nover = \"punch\"\nof = \"" + of +
                                        "\"\nsays = '" + says + "'\n",
                                    punches);
    return audit_of(ledger).claims.front().outcome;
}

Verdict verdict(const std::string& of, const std::string& says) {
    return judged("value", of, says).verdict;
}

std::string refused(const std::string& claim, const std::string& families = punches) {
    try {
        static_cast<void>(audit_of(ledger_of(claim, families)));
        return "";
    } catch (const InputError& error) {
        return error.what();
    }
}

bool holds(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

std::string with(std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
}

} // namespace

// p = P/(pi sqrt(a^2 - x^2)): johnson1985, eq. 2.64.
TEST_CASE("a rigid flat punch as a family of a ledger") {
    CHECK(verdict("p(x)", "P/(Pi*sqrt(a^2-x^2))") == Verdict::confirmed);
    CHECK(verdict("p(x)", R"(\frac{P}{\pi\sqrt{a^2-x^2}})") == Verdict::confirmed);
    CHECK(verdict("p(x)", "P/(Pi*sqrt(u*(2*a-u)))") == Verdict::confirmed);
    CHECK(verdict("p(0)", "P/(Pi*a)") == Verdict::confirmed);
    CHECK(verdict("integral(p(s), s, -a, a)", "P") == Verdict::confirmed);
    CHECK(verdict("b", "a") == Verdict::confirmed);
    // The expansion of P/(pi sqrt(2 a u)) (1 - u/(2 a))^(-1/2).
    CHECK(verdict("right.s0", "P/(Pi*sqrt(2*a))") == Verdict::confirmed);
    CHECK(verdict("left.s1", "P/(4*Pi*a*sqrt(2*a))") == Verdict::confirmed);
    SUBCASE("misprints are refuted and corrected") {
        const Outcome half = judged("value", "p(x)", "P/(2*sqrt(a^2-x^2))");
        CHECK(half.verdict == Verdict::refuted);
        REQUIRE(half.correct.has_value());
        CHECK(verdict("p(x)", *half.correct) == Verdict::confirmed);
        // The body of revolution: P/(2 pi a sqrt(a^2 - r^2)).
        CHECK(verdict("p(x)", "P/(2*Pi*a*sqrt(a^2-x^2))") == Verdict::refuted);
        CHECK(verdict("right.s0", "P/(Pi*sqrt(a))") == Verdict::refuted);
    }
    SUBCASE("the pressure is singular at the edge, with the exponent -1/2") {
        CHECK(judged("order", "p(x)", "u^(-1/2)").verdict == Verdict::confirmed);
        CHECK(judged("order", "p(x)", "u^(1/2)").verdict == Verdict::refuted);
    }
}

TEST_CASE("a flat punch has no slope, and needs no modulus") {
    const std::string claim = "kind = \"value\"\nover = \"punch\"\nof = \"p(x)\"\nsays = \"P\"\n";
    CHECK(refused(claim) == "");
    for (const char* name : {"P1", "M", "Es", "right.c0", "Pof(a)", "g1(x)", "gap(2*a)"}) {
        CAPTURE(name);
        CHECK(holds(refused(with(claim, "says = \"P\"", std::string("says = \"") + name + "\"")),
                    "is not available in the family punch of flat punches"));
    }
    CHECK(holds(refused(with(claim, "\"value\"", "\"identity\"")), "is of kind identity"));
    CHECK(holds(refused(claim, with(punches, "P = [\"7/5\", \"2e4\"]", "")), "has no P"));
    CHECK(holds(refused(claim, with(punches, "7/5", "-7/5")), "P = -7/5 is not positive"));
    CHECK(holds(refused(claim, with(punches, "P =", "Q = [\"1\"]\nP =")),
                "is a flat punch: Q has no effect on it"));
    CHECK(holds(refused(claim, with(punches, "P =", "Es = [\"1\"]\nP =")),
                "the parameter Es of family punch has no effect"));
    CHECK(holds(refused(claim, punches + "[[family]]\nname = \"both\"\nunion = [\"punch\"]\n"),
                "the family 'punch' is a flat punch"));
}
