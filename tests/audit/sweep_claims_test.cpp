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

TEST_CASE("what grows with a parameter, what falls, and what does both") {
    CHECK(verdict_of(monotone("m", "increasing")) == "confirmed");
    CHECK(verdict_of(monotone("m", "decreasing")) == "refuted");
    CHECK(verdict_of(monotone("1/m", "decreasing")) == "confirmed");
    CHECK(verdict_of(monotone("(m-5)^2", "increasing")) == "refuted"); // falls from 2 to 4
    CHECK(verdict_of(monotone("m-m", "increasing")) == "undecided");
    // c_1/c_0 is proportional to 5/8 - m, a rational of hand calculation.
    CHECK(verdict_of(monotone("right.c1/right.c0", "decreasing")) == "confirmed");
    CHECK(verdict_of(monotone("right.c1/right.c0", "increasing")) == "refuted");
}

TEST_CASE("along a name of its own") {
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
    // A rectangular punch: P/(pi sqrt(a^2 - x^2)), approached as 1/m.
    CHECK(verdict_of(limit("p(0)*Pi*a/P", "2")) != "confirmed");
}

TEST_CASE("the best value of a parameter, for one tolerance and in the limit") {
    // To first order the error is proportional to 5/8 - m; the second order shifts the best value
    // at any finite tolerance, by about its square root.
    CHECK(verdict_of(optimum("5/8", "\"1/100\"", "each"), 20) == "refuted");
    CHECK(verdict_of(optimum("5/8", R"("1e-2", "1e-5")", "limit"), 20) == "confirmed");
    CHECK(verdict_of(optimum("3/4", R"("1e-2", "1e-5")", "limit"), 20) == "refuted");
    const ClaimResult r = result_of(optimum("1", "\"1/100\"", "each"), 20);
    CHECK(name_of(r.outcome.verdict) == "refuted");
    // The reach is largest where the inner maximum of sqrt(2u)/I_m(1 - u) - 1 is the tolerance, and
    // goes to where the same falls to its negative: by mpmath at 45 digits, findroot on 2F1 (the
    // source of tests/contact/design/design_test.cpp). Hertz: 1 - (100/101)^2.
    REQUIRE(r.outcome.computed);
    const std::string& said = *r.outcome.computed;
    CAPTURE(said);
    CHECK(said.find("m = 0.66796666538144596791,") != std::string::npos);
    CHECK(said.find("0.45016636517377882362 of a + b (proved)") != std::string::npos);
    CHECK(said.find("the value claimed reaches 0.019703950593079109891") != std::string::npos);
}
