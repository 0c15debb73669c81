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

TEST_CASE("the half-width of a sphere, for that of a cylinder, is corrected by the ratio") {
    const std::string cylinders =
        "[ledger]\nname = \"cylinders\"\n[[family]]\nname = \"cylinder\"\n"
        "profile = \"power-law\"\ncount = 6\n[family.parameters]\n"
        "m = [\"1\"]\nC = [\"3/7\", \"1e-6\"]\na = [\"3/2\", \"7e5\", "
        "\"0.02\"]\nEs = [\"7/3\", \"2.1e11\"]\n";
    const auto outcome = [&](const std::string& says) {
        return small_ledger::audit_of(
                   small_ledger::ledger_of("kind = \"value\"\nover = \"cylinder\"\nof = \"a\"\n"
                                           "says = \"" +
                                               says + "\"\n",
                                           cylinders))
            .claims.front()
            .outcome;
    };
    // a = (3 P R/(4 Es))^(1/3) of a sphere (johnson1985, eq. 4.22), with C = 1/R.
    const std::string sphere = "(3*P/(4*Es*C))^(1/3)";
    const Outcome wrong = outcome(sphere);
    CHECK(wrong.verdict == Verdict::refuted);
    REQUIRE(wrong.correct.has_value());
    CHECK(wrong.correct->starts_with(sphere));
    CHECK(outcome(*wrong.correct).verdict == Verdict::confirmed);
    // The cylinder: eq. 4.43.
    CHECK(outcome("sqrt(4*P/(Pi*Es*C))").verdict == Verdict::confirmed);
}
