// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/precision/error.hpp"
#include "tests/audit/small_ledger.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

using namespace edgeproof::small_ledger;

namespace {

std::string relation(const std::string& says, const std::string& more = "",
                     const std::string& over = "hertz") {
    return "kind = \"relation\"\nover = \"" + over + "\"\nsays = \"" + says + "\"\n" + more;
}

/// Returns the interval in which it fails (or holds) in the first scene of the evidence.
std::string first_interval(const ClaimResult& r, const char* key) {
    const auto* list = r.outcome.evidence.find("in_scenes");
    REQUIRE(list != nullptr);
    const auto& scene =
        std::get<Evidence>(std::get<std::vector<EvidenceItem>>(list->value()).front().value());
    const auto* intervals = scene.find(key);
    REQUIRE(intervals != nullptr);
    return std::get<std::vector<EvidenceItem>>(intervals->value()).front().text();
}

} // namespace

TEST_CASE("a relation that holds everywhere, and its opposite") {
    // Hertz: every truncation lies above the pressure, as all coefficients except the first are <
    // 0.
    CHECK(verdict_of(relation("right_local(1, x) > p(x) and right_local(2, x) > p(x)")) ==
          "confirmed");
    CHECK(verdict_of(relation("right_local(1, x) < p(x)")) == "refuted");
    CHECK(verdict_of(relation("right_local(1, x) > p(x) and right_local(2, x) < p(x)")) ==
          "refuted");
    CHECK(verdict_of(relation("p(x) = Es*C/2*sqrt(a^2-x^2)")) == "confirmed");
    CHECK(verdict_of(relation("p(x) = Es*C/2*sqrt(a^2-x^2)*(1+1e-20)")) == "refuted");
    CHECK(verdict_of(relation("p(x) <= Es*C/2*sqrt(a^2-x^2)")) == "confirmed");
}

TEST_CASE("a failing region far narrower than the scan is found, and its ends") {
    // (u/L - 1/3)^2 > w^2 fails for |u/L - 1/3| < w.
    CHECK(verdict_of(relation("(u/L-3217/10000)^2 > 1e-12")) == "refuted");
    CHECK(verdict_of(relation("(u/L-3217/10000)^2 > -1e-12")) == "confirmed");
    const ClaimResult r = result_of(relation("(u/L-3217/10000)^2 > 1e-6"));
    CHECK(first_interval(r, "fails_in") == "u/L = 0.3207000000 ... 0.3227000000");
}

TEST_CASE("somewhere, nowhere, near the edge") {
    const auto holds = [](const std::string& how) { return "holds = \"" + how + "\""; };
    CHECK(verdict_of(relation("u/L > 0.9", holds("somewhere"))) == "confirmed");
    CHECK(verdict_of(relation("u/L > 1.1", holds("somewhere"))) == "refuted");
    CHECK(verdict_of(relation("(u/L-3217/10000)^2 < 1e-12", holds("somewhere"))) == "confirmed");
    CHECK(verdict_of(relation("u/L > 1.1", holds("nowhere"))) == "confirmed");
    CHECK(verdict_of(relation("u/L > 0.9", holds("nowhere"))) == "refuted");
    CHECK(verdict_of(relation("u/L < 1e-12", holds("near-edge"))) == "confirmed");
    CHECK(verdict_of(relation("u/L > 1e-12", holds("near-edge"))) == "refuted");
    CHECK_THROWS_AS(static_cast<void>(verdict_of(relation("u > 0 and u < a", holds("nowhere")))),
                    InputError);
}

TEST_CASE("a difference beyond the digits at hand is found with more of them") {
    // At u = 1e-40 L the one-term approximation is too large by 2.5e-41 of the pressure.
    CHECK(verdict_of(relation("right_local(1, x) > p(x)", "holds = \"near-edge\""), 20) ==
          "confirmed");
    CHECK(verdict_of(relation("right_local(1, x) < p(x)", "holds = \"near-edge\""), 20) ==
          "refuted");
    // More digits do not separate identical sides: the claim is not a strict inequality and must
    // not be confirmed.
    CHECK(verdict_of(relation("sqrt(u)*sqrt(u) < u"), 20) != "confirmed");
}

TEST_CASE("an inequality that fails at one point is not confirmed") {
    // x = a/3, u = L/3, is a place of the scan, and the value there is 0 or nearly 0.
    for (const unsigned digits : {15U, 30U, 120U}) {
        CHECK(verdict_of(relation("(x-a/3)^2 <= 0", "holds = \"nowhere\""), digits) == "undecided");
        CHECK(verdict_of(relation("(x-a/3)^2 > 0"), digits) == "undecided");
    }
    // With equality at u = L/7 or u = 3 L/7, which no place of the scan meets.
    CHECK(verdict_of(relation("(u/L-1/7)^2 <= 0", "holds = \"nowhere\""), 15) == "undecided");
    CHECK(verdict_of(relation("(u/L-1/7)^2 > 0"), 15) == "undecided");
    CHECK(verdict_of(relation("abs(u/L-3/7) > 0"), 30) == "undecided");
    // Where equality is allowed, it holds there to the digits required.
    CHECK(verdict_of(relation("(u/L-1/7)^2 >= 0"), 15) == "confirmed");
}

TEST_CASE("near the edge, an approximation is not equal to the exact pressure") {
    const std::string near_edge = "holds = \"near-edge\"";
    for (const unsigned digits : {15U, 50U}) {
        CHECK(verdict_of(relation("p(x) = right_local(1, x)", near_edge), digits) == "refuted");
        CHECK(verdict_of(relation("p(x) = Es*C/2*sqrt(a^2-x^2)", near_edge), digits) ==
              "confirmed");
        CHECK(verdict_of(relation("p(x) >= right_local(1, x)", near_edge), digits) == "refuted");
        CHECK(verdict_of(relation("p(x) = right_local(4, x)", near_edge), digits) != "confirmed");
    }
}

TEST_CASE("a relation without a place, and one where a condition leaves places out") {
    CHECK(verdict_of(relation("right.c1 < 0 and right.c0 > 0")) == "confirmed");
    CHECK(verdict_of(relation("right.c1 > 0")) == "refuted");
    CHECK(verdict_of(relation("x > 0", "where = \"u < a\"")) == "confirmed");
    CHECK(verdict_of(relation("x > 0")) == "refuted");
}
