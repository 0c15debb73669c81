// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/precision/error.hpp"
#include "tests/audit/small_ledger.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

using namespace edgeproof::small_ledger;

namespace {

std::string order(const std::string& says, const std::string& more = "") {
    return "kind = \"order\"\nover = \"hertz\"\nof = \"abs(1 - right_local(1, x)/p(x))\"\nsays = "
           "\"" +
           says + "\"\n" + more;
}

std::string series_claim(const std::string& terms, const std::string& orders,
                         const std::string& over = "hertz") {
    return "kind = \"series\"\nover = \"" + over + "\"\nterms = [" + terms + "]\norders = [" +
           orders + "]";
}

} // namespace

TEST_CASE("the order of the one-term error, and what multiplies it") {
    const std::string pure = "factor = \"pure-number\"\n";
    CHECK(verdict_of(order("u")) == "confirmed");
    CHECK(verdict_of(order("u^2")) == "refuted");
    CHECK(verdict_of(order("u^(3/2)")) == "refuted");
    CHECK(verdict_of(order("sqrt(u)")) == "imprecise"); // true as a bound, but not the order
    // The error is u/(4 a) + ..., of the order of u/a, not of u.
    CHECK(verdict_of(order("u/a", pure)) == "confirmed");
    CHECK(verdict_of(order("u", pure)) == "refuted");
    CHECK(verdict_of(order("right.c1/right.c0*u", pure)) == "confirmed");
    const ClaimResult corrected =
        result_of(order("right.c1*u", pure + "candidates = [\"right.c1*u^2\", \"u/(3*a)\"]"));
    CHECK(name_of(corrected.outcome.verdict) == "refuted");
    REQUIRE(corrected.outcome.correct.has_value());
    CHECK(*corrected.outcome.correct == "u/(3*a)");
}

TEST_CASE("residuals have the orders and the coefficients claimed, or not") {
    // Hertz: Es C/2 sqrt(2 a u) sqrt(1 - u/(2a)).
    const std::string c0 = "\"Es*C/2*sqrt(2*a)\"";
    const std::string c1 = "\"-(Es*C/2*sqrt(2*a))/(4*a)\"";
    const std::string halves = R"("1/2", "3/2", "5/2")";
    CHECK(verdict_of(series_claim(c0 + ", " + c1, halves)) == "confirmed");
    CHECK(verdict_of(series_claim(c0 + ", " + c1, R"("1/2", "3/2")")) == "confirmed");
    CHECK(verdict_of(series_claim(c0 + ", " + c1, R"("1/2", "3/2", "7/2")")) == "refuted");
    CHECK(verdict_of(series_claim(c0, R"("1/2", "1")")) == "refuted");
    CHECK(verdict_of(series_claim(c0, R"("3/2", "5/2")")) == "refuted");
    CHECK(verdict_of(series_claim(c0 + ", \"Es*C/2*sqrt(2*a)/(4*a)\"", halves)) ==
          "refuted"); // sign
    CHECK(verdict_of(series_claim("\"Es*C/2*sqrt(2*a)*(1+1e-20)\"", R"("1/2", "3/2")")) ==
          "refuted");
}

TEST_CASE("past 100 digits the coefficients are proved to all digits in six scenes") {
    const std::string c0 = "Es*C/2*sqrt(2*a)";
    const std::string halves = R"("1/2", "3/2")";
    const ClaimResult r = result_of(series_claim('"' + c0 + '"', halves, "nine"), 130);
    // The printed coefficient is right for m = 1, and wrong for the other values.
    CHECK(name_of(r.outcome.verdict) == "refuted");
    const ClaimResult right = result_of(series_claim("\"right.c0\"", halves, "nine"), 130);
    CHECK(name_of(right.outcome.verdict) == "confirmed");
    const auto number = [&](const char* key) {
        const auto* const found = right.outcome.evidence.find(key);
        return found == nullptr ? -1 : std::stoi(found->text());
    };
    CHECK(number("scenes") == 9);
    CHECK(number("scenes_to_all_digits") == 6);
    CHECK(number("digits_of_the_coefficients") > 95);
    CHECK(number("all_digits_of_the_coefficients") > 125);
    // The relative error is 1e-115.
    CHECK(verdict_of(series_claim('"' + c0 + "*(1+1e-115)\"", halves), 130) == "refuted");
    CHECK(verdict_of(series_claim('"' + c0 + '"', halves), 130) == "confirmed");
    CHECK(verdict_of(series_claim('"' + c0 + "*(1+1e-115)\"", halves), 100) == "refuted");
}

TEST_CASE("a coefficient that vanishes leaves the next order, and is reported") {
    const ClaimResult r =
        result_of(series_claim("\"right.c0\"", R"("1/2", "3/2")", "five-eighths"));
    CHECK(name_of(r.outcome.verdict) == "confirmed");
    const auto* vanishing = r.outcome.evidence.find("scenes_where_a_coefficient_vanishes");
    REQUIRE(vanishing != nullptr);
    CHECK(vanishing->text() == "1");
}

TEST_CASE("orders that do not match the terms are refused") {
    CHECK_THROWS_AS(static_cast<void>(verdict_of(series_claim(R"("1", "2")", "\"1/2\""))),
                    InputError);
    CHECK_THROWS_AS(static_cast<void>(verdict_of(series_claim("\"1\"", "\"half\""))), InputError);
}
