// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/precision/error.hpp"
#include "tests/audit/small_ledger.hpp"

#include "edgeproof/precision/rounding/text.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

using namespace edgeproof::small_ledger;

namespace {

std::string monotone(const std::string& of, const std::string& sense,
                     const std::string& more = "along = \"m\"") {
    return "kind = \"monotone\"\nover = \"powers\"\nof = \"" + of + "\"\nsense = \"" + sense +
           "\"\n" + more;
}
std::string limit(const std::string& of, const std::string& limit,
                  const std::string& more = "along = \"m\"") {
    return "kind = \"limit\"\nover = \"powers\"\nof = \"" + of + "\"\nlimit = \"" + limit + "\"\n" +
           more;
}
std::string optimum(const std::string& at, const std::string& tolerances,
                    const std::string& sense) {
    return "kind = \"optimum\"\nover = \"five-eighths\"\nalong = \"m\"\nat = \"" + at +
           "\"\nbetween = [\"0\", \"2\"]\nterms = 1\nupto = \"1/2\"\ntolerances = [" + tolerances +
           "]\nsense = \"" + sense + "\"";
}

const std::string along_s =
    "along = \"s\"\nvary = { s = [\"1/10\", \"1/100\", \"1e-4\", \"1e-8\"] }";

} // namespace

TEST_CASE("quantities that increase, decrease, or do both with a parameter") {
    CHECK(verdict_of(monotone("m", "increasing")) == "confirmed");
    CHECK(verdict_of(monotone("m", "decreasing")) == "refuted");
    CHECK(verdict_of(monotone("1/m", "decreasing")) == "confirmed");
    CHECK(verdict_of(monotone("(m-5)^2", "increasing")) == "refuted"); // decreases from 2 to 4
    CHECK(verdict_of(monotone("m-m", "increasing")) == "undecided");
    // c_1/c_0 is proportional to 5/8 - m, by hand calculation.
    CHECK(verdict_of(monotone("right.c1/right.c0", "decreasing")) == "confirmed");
    CHECK(verdict_of(monotone("right.c1/right.c0", "increasing")) == "refuted");
}

TEST_CASE("monotone along a variable of the claim") {
    CHECK(verdict_of(monotone("s", "decreasing", along_s)) == "confirmed");
    CHECK(verdict_of(monotone("a*sqrt(1-s^2)", "increasing", along_s)) == "confirmed");
    CHECK(verdict_of(monotone("a*sqrt(1-s^2)", "decreasing", along_s)) == "refuted");
}

TEST_CASE("a sweep needs values, and all its samples") {
    CHECK_THROWS_AS(static_cast<void>(verdict_of(monotone("m", "increasing", "along = \"Es\""))),
                    InputError);
    CHECK_THROWS_AS(static_cast<void>(verdict_of(monotone("m", "increasing", "along = \"k\""))),
                    InputError);
    CHECK_THROWS_AS(static_cast<void>(verdict_of(
                        monotone("m", "increasing", "along = \"m\"\nwhere = \"x > 0\""))),
                    InputError);
}

TEST_CASE("limits that are reached, limits that are not") {
    CHECK(verdict_of(limit("s", "0", along_s)) == "confirmed");
    CHECK(verdict_of(limit("1+s", "1", along_s)) == "confirmed");
    CHECK(verdict_of(limit("1+s", "0", along_s)) == "refuted");
    CHECK(verdict_of(limit("1+s", "1+1e-3", along_s)) == "refuted");
    CHECK(verdict_of(limit("1/s", "0", along_s)) == "refuted");
    CHECK(verdict_of(limit("m", "infinity")) == "confirmed");
    CHECK(verdict_of(limit("1/m", "infinity")) == "refuted");
    CHECK(verdict_of(limit("m/(1+m)", "infinity")) != "confirmed");
    CHECK(verdict_of(limit("2-s", "infinity", along_s)) == "refuted");
    // The limit is a rectangular punch, P/(pi sqrt(a^2 - x^2)); the difference decreases as 1/m.
    CHECK(verdict_of(limit("p(0)*Pi*a/P", "1")) == "confirmed");
    CHECK(verdict_of(limit("p(0)*Pi*a/P", "2")) == "refuted");
    CHECK(verdict_of(limit("p(0)*Pi*a/P", "1+1e-9")) != "confirmed");
}

TEST_CASE("a limit is judged by what lies beyond the values listed") {
    const std::string along_big = "along = \"s\"\nvary = { s = [\"1\", \"10\", \"100\"] }";
    // At the listed values it decreases to 1e60*exp(-300) = 5e-71 + 1.
    CHECK(verdict_of(limit("1+1e60*exp(-3*s)", "0", along_big)) == "refuted");
    CHECK(verdict_of(limit("1+1e60*exp(-3*s)", "1", along_big)) == "confirmed");
    CHECK(verdict_of(limit("1e-60*exp(s/3)", "0", along_big)) == "refuted");
    CHECK(verdict_of(limit("1e-60*exp(s/3)", "infinity", along_big)) == "confirmed");
    // exp(-1e8) is outside the range of printed numbers.
    CHECK(verdict_of(limit("exp(-1/s)", "0", along_s)) == "confirmed");
    CHECK(verdict_of(limit("exp(1/s)", "infinity", along_s)) == "confirmed");
    CHECK(verdict_of(limit("-exp(1/s)", "infinity", along_s)) == "refuted");
    // At s = 1e30 and at s = 1e-40 another term becomes dominant.
    CHECK(verdict_of(limit("1/(1+1e-30*s)", "0", along_big)) == "confirmed");
    CHECK(verdict_of(limit("1/(1+1e-30*s)", "1", along_big)) == "refuted");
    CHECK(verdict_of(limit("s/(1+1e-30*s)", "infinity", along_big)) == "refuted");
    CHECK(verdict_of(limit("s/(1+1e-30*s)", "1e30", along_big)) == "confirmed");
    CHECK(verdict_of(limit("s/(s+1e-40)", "0", along_s)) == "confirmed");
    CHECK(verdict_of(limit("s/(s+1e-40)", "1", along_s)) == "refuted");
    CHECK(verdict_of(limit("1+s^2-1e-40", "1", along_s)) == "refuted");
    CHECK(verdict_of(limit("1+s^2-1e-40", "1-1e-40", along_s)) == "confirmed");
}

TEST_CASE("terms that dominate beyond the range that is followed do not decide") {
    const std::string along_big = "along = \"s\"\nvary = { s = [\"1\", \"10\", \"100\"] }";
    for (const char* claimed : {"0", "1", "infinity"}) {
        CAPTURE(claimed);
        for (const char* of : {"s/(s+1e-5000)", "1/(1+1e-3*log(1/s))", "s^(1/10000)",
                               "step(log(1/s)-5000)", "step(1/20-s^(1/1000))", "sin(1/s)"}) {
            CAPTURE(of);
            CHECK(verdict_of(limit(of, claimed, along_s)) == "undecided");
        }
        for (const char* of :
             {"s/(s+1e5000)", "log(log(s+2)+1)-9", "1/s+exp(-1e3-1/s)", "log(s)/(1+1e-5*log(s))"}) {
            CAPTURE(of);
            CHECK(verdict_of(limit(of, claimed, along_big)) != "confirmed");
        }
    }
    // The true limits are 0, 0, infinity, exp(-1000), 1e5.
    CHECK(verdict_of(limit("s/(s+1e5000)", "1", along_big)) == "undecided");
    CHECK(verdict_of(limit("log(log(s+2)+1)-9", "infinity", along_big)) == "undecided");
    CHECK(verdict_of(limit("1/s+exp(-1e3-1/s)", "exp(-1e3)", along_big)) != "refuted");
    CHECK(verdict_of(limit("log(s)/(1+1e-5*log(s))", "1e5", along_big)) == "undecided");
}

TEST_CASE("slow growth and slow decay are never taken for their opposite") {
    const std::string along_big =
        "along = \"s\"\nvary = { s = [\"1e2\", \"1e4\", \"1e8\", \"1e16\"] }";
    CHECK(verdict_of(limit("log(s)", "infinity", along_big)) != "refuted");
    CHECK(verdict_of(limit("log(log(s))", "infinity", along_big)) != "refuted");
    CHECK(verdict_of(limit("1/log(s)", "0", along_big)) != "refuted");
    CHECK(verdict_of(limit("1/log(s)", "0.02", along_big)) != "confirmed");
    CHECK(verdict_of(limit("1+1/log(s)", "1", along_big)) != "refuted");
    CHECK(verdict_of(limit("s^(1/10)", "infinity", along_big)) == "confirmed");
    CHECK(verdict_of(limit("s^(1/10)", "1e3", along_big)) == "refuted");
    CHECK(verdict_of(limit("s^(-1/10)", "0", along_big)) == "confirmed");
}

TEST_CASE("oscillation, exact equality, and values that a formula makes special") {
    CHECK(verdict_of(limit("sin(1/s)*s", "0", along_s)) == "confirmed");
    CHECK(verdict_of(limit("1+sin(1/s)*s", "1", along_s)) == "confirmed");
    CHECK(verdict_of(limit("1+sin(1/s)*s", "1+1e-9", along_s)) == "refuted");
    // This function is zero at each power of ten.
    CHECK(verdict_of(limit("sin(Pi/s)", "0", along_s)) == "undecided");
    CHECK(verdict_of(limit("a*C/(C*a)", "1", along_s)) == "confirmed");
    CHECK(verdict_of(limit("a*C/(C*a)", "1+1e-30", along_s)) == "refuted");
    CHECK(verdict_of(limit("a*C/(C*a)", "infinity", along_s)) == "refuted");
    CHECK(verdict_of(limit("s+1/3", "0." + std::string(60, '3'), along_s)) == "refuted");
    CHECK(verdict_of(limit("(1+1/s)*s-1", "0", along_s)) == "confirmed");
    CHECK(verdict_of(limit("s-s", "0", along_s)) == "confirmed");
}

TEST_CASE("the value that the listed values approach") {
    const auto along = [](const std::string& values) {
        return "along = \"s\"\nvary = { s = [" + values + "] }";
    };
    // The values tend to a multiple of a parameter of the scene, or to 1/3.
    const std::string to_a = along(R"("a/2", "a*9/10", "a-a*1e-3", "a-a*1e-9")");
    CHECK(verdict_of(limit("s/a", "1", to_a)) == "confirmed");
    CHECK(verdict_of(limit("s/a", "1-1e-9", to_a)) == "refuted");
    CHECK(verdict_of(limit("1/(a-s)", "infinity", to_a)) == "confirmed");
    CHECK(verdict_of(limit("1/(s-a)", "infinity", to_a)) == "refuted"); // minus infinity
    const std::string to_third = along(R"("0.3", "0.33", "0.333", "0.3333")");
    CHECK(verdict_of(limit("3*s", "1", to_third)) == "confirmed");
    CHECK(verdict_of(limit("s", "0.33333", to_third)) == "refuted");
    const std::string from_above = along(R"("a*2", "a+a*1e-2", "a+a*1e-5")");
    CHECK(verdict_of(limit("sqrt(s/a-1)", "0", from_above)) == "confirmed");
    // The values do not tend to a simple number, and the steps are not halved.
    const std::string uneven = along(R"("1", "1000", "1500")");
    CHECK(verdict_of(limit("s", "infinity", uneven)) == "undecided");
    CHECK(verdict_of(limit("s", "1500", uneven)) == "undecided");
    CHECK(verdict_of(limit("s", "sqrt(2)", along(R"("1", "1.4", "1.41", "1.414")"))) ==
          "undecided");
}

TEST_CASE("limits of a contact at distances far below the requested digits") {
    // The remainder of Hertz's pressure after three terms decreases as s^3.
    const std::string tiny =
        "along = \"s\"\nvary = { s = [\"a*1e-30\", \"a*1e-35\", \"a*1e-40\"] }";
    const auto hertz = [&](const std::string& of, const std::string& claimed) {
        return "kind = \"limit\"\nover = \"hertz\"\nof = \"" + of + "\"\nlimit = \"" + claimed +
               "\"\n" + tiny;
    };
    CHECK(verdict_of(hertz("abs(1-right_local(3,a-s)/p(a-s))", "0")) == "confirmed");
    CHECK(verdict_of(hertz("abs(1-right_local(3,a-s)/p(a-s))", "1e-90")) == "refuted");
    // Expanded by hand, with v = u/(2a): sqrt(1 - v) = 1 - v/2 - v^2/8 - v^3/16 - ...
    CHECK(verdict_of(hertz("(1-right_local(3,a-s)/p(a-s))*(2*a/s)^3", "-1/16")) == "confirmed");
    CHECK(verdict_of(hertz("(1-right_local(3,a-s)/p(a-s))*(2*a/s)^3", "1/16")) == "refuted");
    // p is of the order of sqrt(s).
    CHECK(verdict_of(hertz("p(a-s)/sqrt(s)", "0")) == "refuted");
    CHECK(verdict_of(hertz("p(a-s)*s/sqrt(s)", "0")) == "confirmed");
}

TEST_CASE("the best value of a parameter, for one tolerance and in the limit") {
    // In first order the error is proportional to 5/8 - m; the second order shifts the best value
    // at a finite tolerance by about the square root of the tolerance.
    CHECK(verdict_of(optimum("5/8", "\"1/100\"", "each"), 20) == "refuted");
    CHECK(verdict_of(optimum("5/8", R"("1e-2", "1e-5")", "limit"), 20) == "confirmed");
    CHECK(verdict_of(optimum("3/4", R"("1e-2", "1e-5")", "limit"), 20) == "refuted");
    const ClaimResult r = result_of(optimum("1", "\"1/100\"", "each"), 20);
    CHECK(name_of(r.outcome.verdict) == "refuted");
    // The reach is largest where the inner maximum of sqrt(2u)/I_m(1 - u) - 1 equals the tolerance.
    // It ends where this function has decreased to the negative tolerance: computed with mpmath at
    // 45 digits, findroot on 2F1 (the source of tests/contact/design/design_test.cpp). Hertz: 1 -
    // (100/101)^2.
    REQUIRE(r.outcome.computed);
    const std::string& said = *r.outcome.computed;
    CAPTURE(said);
    CHECK(said.find("m = 0.66796666538144596791,") != std::string::npos);
    CHECK(said.find("0.45016636517377882362 of a + b (proved)") != std::string::npos);
    CHECK(said.find("the value claimed reaches 0.019703950593079109891") != std::string::npos);
}
