// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/audit/small_ledger.hpp"

#include <doctest/doctest.h>

#include <string>

// Misprints at two places, or throughout a formula, of the results of Hertz for g' = C x:
// p = Es C/2 sqrt(a^2 - x^2) = Es C/2 a cos(asin(x/a)), P = Pi/4 Es C a^2 (`johnson1985`,
// sec. 4.2).

namespace {

/// The kind of the change, and the corrected formula.
std::string two_place_correction(const std::string& of, const std::string& says) {
    const ClaimResult r = small_ledger::result_of("kind = \"value\"\nover = \"hertz\"\nof = \"" +
                                                  of + "\"\nsays = \"" + says + "\"\n");
    CHECK(name_of(r.outcome.verdict) == "refuted");
    return r.outcome.note.substr(0, r.outcome.note.find(':')) + ": " +
           r.outcome.correct.value_or("none");
}

} // namespace

TEST_CASE("misprints at two places are corrected: names exchanged, lost exponents, a name") {
    CHECK(two_place_correction("P", "Pi/4*Es*a*C^2") == "names exchanged: Pi/4*Es*C*a^2");
    CHECK(two_place_correction("p(x)", "Es*C/2*sqrt(a - x)") ==
          "exponents: Es*C/2*sqrt(a^2 - x^2)");
    CHECK(two_place_correction("p(x)", "2*P/(Pi*a)*sqrt(1 - x/a)") ==
          "exponent: 2*P/(Pi*a)*sqrt(1 - (x/a)^2)");
    // Half of the modulus at both places of p = sqrt(P Es C/Pi) sqrt(1 - Pi Es C x^2/(4 P)).
    CHECK(two_place_correction("p(x)", "sqrt(P*Es/2*C/Pi)*sqrt(1 - Pi*Es/2*C*x^2/(4*P))")
              .starts_with("factor missing throughout: "));
}

TEST_CASE("another inverse function, and degrees for radians, are corrected") {
    CHECK(two_place_correction("p(x)", "Es*C/2*a*cos(atan(x/a))") ==
          "function: Es*C/2*a*cos(asin(x/a))");
    CHECK(two_place_correction("p(x)", "Es*C/2*a*cos(asin(x/a)*180/Pi)").starts_with("degrees: "));
}

TEST_CASE("g printed for its slope g' is corrected") {
    // P = Es integral(s g'(s)/sqrt(a^2 - s^2), s, 0, a) with g = C s^2/2, g' = C s.
    const std::string corrected =
        two_place_correction("P", "Es*integral(s*(C*s^2/2)/sqrt(a^2 - s^2), s, 0, a)");
    CHECK(corrected.starts_with("derivative: "));
    CHECK(corrected.find("C*(2*s)/2") != std::string::npos);
    // The slope of the profile itself.
    CHECK(two_place_correction("g1(x)", "C*x^2/2").starts_with("derivative: "));
}

TEST_CASE("formulas of a sphere, for those of a cylinder, are corrected") {
    const std::string cylinders =
        "[ledger]\nname = \"cylinders\"\n[[family]]\nname = \"cylinder\"\n"
        "profile = \"power-law\"\ncount = 6\n[family.parameters]\n"
        "m = [\"1\"]\nC = [\"3/7\", \"1e-6\"]\na = [\"3/2\", \"7e5\", "
        "\"0.02\"]\nEs = [\"7/3\", \"2.1e11\"]\n";
    const std::string one_contact = "[ledger]\nname = \"one\"\n[[family]]\nname = \"cylinder\"\n"
                                    "profile = \"power-law\"\ncount = 1\n[family.parameters]\n"
                                    "m = [\"1\"]\nC = [\"1/50\"]\na = [\"2\"]\nEs = [\"70\"]\n";
    const auto outcome = [&](const std::string& of, const std::string& says,
                             const std::string& ledger) {
        return small_ledger::audit_of(
                   small_ledger::ledger_of("kind = \"value\"\nover = \"cylinder\"\nof = \"" + of +
                                               "\"\nsays = \"" + says + "\"\n",
                                           ledger))
            .claims.front()
            .outcome;
    };
    // johnson1985, equations 4.22 to 4.24 (a sphere) and 4.43 to 4.45, with C = 1/R.
    struct Pair {
        const char* of;
        const char* sphere;
        const char* cylinder;
    };
    for (const std::string& ledger : {cylinders, one_contact}) {
        for (const Pair& pair :
             {Pair{"a", "(3*P/(4*Es*C))^(1/3)", "sqrt(4*P/(Pi*Es*C))"},
              Pair{"p(0)", "(6*P*Es^2*C^2/Pi^3)^(1/3)", "sqrt(P*Es*C/Pi)"},
              Pair{"P", "4/3*Es*C*a^3", ""}, Pair{"p(0)", "3*P/(2*Pi*a^2)", ""}}) {
            CAPTURE(pair.sphere);
            const Outcome wrong = outcome(pair.of, pair.sphere, ledger);
            CHECK(wrong.verdict == Verdict::refuted);
            REQUIRE(wrong.correct.has_value());
            if (*pair.cylinder != '\0') {
                CHECK(*wrong.correct == std::string(pair.cylinder));
            }
            // Right for all cylinders, and not by chance for one of them.
            CHECK(outcome(pair.of, *wrong.correct, cylinders).verdict == Verdict::confirmed);
        }
    }
}

TEST_CASE("two edges exchanged in a kernel, so that it has no value, are corrected") {
    const std::string wedges =
        "[ledger]\nname = \"wedges\"\n[[family]]\nname = \"wedge\"\nprofile = \"tilted-wedge\"\n"
        "count = 3\nu = [\"1/5\", \"1/100\"]\n[family.parameters]\ngam = [\"1/40\", \"9/10\"]\n"
        "phi = [\"pi/16\", \"1/50\"]\nalpha = [\"2*phi/pi*asin((1-gam)/(1+gam))\"]\n"
        "a = [\"3/2\", \"7\"]\nEs = [\"7/3\"]\n";
    const auto outcome = [&](const std::string& kernel, const std::string& root = "(a-x)*(b+x)",
                             const std::string& limits = "-b, a") {
        return small_ledger::audit_of(
                   small_ledger::ledger_of(
                       "kind = \"value\"\nover = \"wedge\"\nof = \"p(x)\"\nsays = "
                       "\"Es/(2*Pi)*sqrt(" +
                           root + ")*pv(g1(s)/sqrt(" + kernel + ")/(s-x), s, " + limits +
                           ", x)\"\n",
                       wedges))
            .claims.front()
            .outcome;
    };
    CHECK(outcome("(a-s)*(b+s)").verdict == Verdict::confirmed);
    for (const Outcome& exchanged :
         {outcome("(b-s)*(a+s)"), outcome("(a-s)*(b+s)", "(a-x)*(b+x)", "-a, b"),
          outcome("(b-s)*(a+s)", "(b-x)*(a+x)")}) {
        CHECK(exchanged.verdict == Verdict::underspecified);
        CHECK(exchanged.note.find("has no value as printed") == 0);
        CHECK(exchanged.note.find("; names exchanged: ") != std::string::npos);
        REQUIRE(exchanged.correct.has_value());
        CHECK(exchanged.correct->find("(a - x)*(b + x)") != std::string::npos);
        CHECK(exchanged.correct->find("(a - s)*(b + s)") != std::string::npos);
        CHECK(exchanged.correct->find("s, -b, a, x)") != std::string::npos);
    }
}
