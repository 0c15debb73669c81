// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/audit/small_ledger.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

namespace {

std::string varied_verdict(const std::string& says, const std::string& vary) {
    return small_ledger::verdict_of("kind = \"value\"\nover = \"hertz\"\nof = \"Pi\"\nsays = \"" +
                                    says + "\"\nvary = { " + vary + " }");
}

} // namespace

TEST_CASE("right at some samples, clearly without a value at others: underspecified") {
    const std::string from_edge = "integral(1/sqrt((a-s)*(s+a)), s, -a, k*a)";
    CHECK(varied_verdict(from_edge, R"(k = ["1"])") == "confirmed");
    CHECK(varied_verdict(from_edge, R"(k = ["1", "1.01"])") == "underspecified");
    CHECK(varied_verdict(from_edge, R"(k = ["1", "2"])") == "underspecified");
    CHECK(varied_verdict("Pi + sqrt(1-k) - sqrt(1-k)", R"(k = ["1/2", "3"])") == "underspecified");
    CHECK(varied_verdict("Pi + (1-k)^(3/2) - (1-k)^(3/2)", R"(k = ["1/2", "3"])") ==
          "underspecified");
}

TEST_CASE("beyond the contact, at no size, over nothing: underspecified") {
    for (const char* says :
         {"Pi + p(k*a) - p(k*a)", "Pi + integral(p(s), s, -k*a, k*a)/P - 1",
          "Pi*bof(-k*a)/bof(-k*a)", "Pi + binv(-k*a) - binv(-k*a)", "Pi + Pof(-k*a) - Pof(-k*a)",
          "Pi + P1of(-k*a) - P1of(-k*a)", "Pi + 1/b2 - 1/b2", "Pi + k/(a*b3) - k/(a*b3)"}) {
        CAPTURE(std::string(says));
        CHECK(varied_verdict(says, R"(k = ["3/2"])") == "underspecified");
    }
}

TEST_CASE("a principal value whose pole is beyond its interval is an integral like any other") {
    // Integrated by hand: ln|1 - k| - ln|k| from 0 to 1.
    CHECK(varied_verdict("Pi + pv(1/(s-k), s, 0, 1, k) + log(2)", R"(k = ["2"])") == "confirmed");
    CHECK(varied_verdict("Pi + pv(1/(s-k), s, 1, 0, k) - log(2)", R"(k = ["2"])") == "confirmed");
    CHECK(varied_verdict("Pi + pv(1/(s-k), s, 1, 1, k)", R"(k = ["2"])") == "confirmed");
    CHECK(varied_verdict("Pi + pv(1/(s-k), s, 0, 1, k) - log(2)", R"(k = ["2"])") == "refuted");
    CHECK(varied_verdict("Pi + pv(1/(s-k), s, 0, 3, k) + log(2)", R"(k = ["2"])") == "confirmed");
}

TEST_CASE("the root of zero, which roundoff makes negative: not underspecified") {
    // These sums are zero; roundoff makes each negative for some of the values of k.
    for (const char* zero : {"a*(1+k) - a - a*k", "(1+k)^2 - 1 - 2*k - k^2", "k - 2*k/3 - k/3",
                             "(a+k)*(a-k) - a^2 + k^2"}) {
        for (const char* k : {"1/3", "1/7", "1/11", "3/13", "5/17", "7/29"}) {
            CAPTURE(std::string(zero));
            CAPTURE(std::string(k));
            const std::string verdict = varied_verdict("Pi + sqrt(" + std::string(zero) + ")",
                                                       "k = [\"" + std::string(k) + "\"]");
            CHECK((verdict == "undecided" || verdict == "confirmed"));
        }
    }
}

TEST_CASE("the roundoff of a zero is shown as a bound, without digits") {
    bool some = false;
    for (const char* zero : {"a*(1+k) - a - a*k", "(sqrt(2)+k)^2 - 2 - 2*sqrt(2)*k - k^2",
                             "sqrt(2+k)*sqrt(3) - sqrt(6+3*k)"}) {
        CAPTURE(zero);
        const ClaimResult r = small_ledger::result_of(
            "kind = \"value\"\nover = \"hertz\"\nof = \"0\"\nsays = \"" + std::string(zero) +
            "\"\nvary = { k = [\"1/3\", \"1/7\", \"5/17\"] }");
        const EvidenceItem* item = r.outcome.evidence.find("printed_there");
        REQUIRE(item != nullptr);
        const std::string text = item->text();
        CAPTURE(text);
        CHECK((text.starts_with("0 +- ") || text.find_first_not_of("-0.e+") == std::string::npos));
        some = some || text.starts_with("0 +- ");
    }
    CHECK(some);
}
