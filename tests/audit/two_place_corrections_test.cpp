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
