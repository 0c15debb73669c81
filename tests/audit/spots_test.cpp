// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/spots.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "small_ledger.hpp"

#include <doctest/doctest.h>

using namespace edgeproof;

namespace {

SpotAgreement without_value(Undefined why = Undefined::unknown) {
    SpotAgreement s;
    s.undefined = true;
    s.why = why;
    s.problem = "sqrt of a number that is negative";
    s.digits = -1e6;
    return s;
}
SpotAgreement unsettled(double digits) {
    SpotAgreement s;
    s.problem = "an integral did not converge";
    s.digits = digits;
    return s;
}
SpotAgreement agreeing(double digits) {
    SpotAgreement s;
    s.digits = digits;
    s.good_digits = 60;
    return s;
}
bool undefined(std::vector<SpotAgreement> spots) {
    Agreement a;
    a.spots = std::move(spots);
    return a.undefined();
}

} // namespace

TEST_CASE("no value at some spot: refuted only where no spot has anything like the right one") {
    CHECK(undefined({without_value(), without_value()}));
    CHECK(undefined({unsettled(0.4), without_value(), unsettled(-2)}));
    CHECK(undefined({agreeing(50), without_value(Undefined::beyond_roundoff)}));
    CHECK_FALSE(undefined({without_value(), without_value(Undefined::by_roundoff)}));
    CHECK_FALSE(undefined({}));
    CHECK_FALSE(undefined({unsettled(0.4), unsettled(1)}));
    CHECK_FALSE(undefined({agreeing(50), without_value()}));
    CHECK_FALSE(undefined({unsettled(12), without_value()}));
}

TEST_CASE("a few that are spread evenly over all come first") {
    using Order = std::vector<std::size_t>;
    CHECK(spread_first(11, 6) == Order{0, 2, 4, 6, 8, 10, 1, 3, 5, 7, 9});
    CHECK(spread_first(7, 3) == Order{0, 3, 6, 1, 2, 4, 5});
    for (const std::size_t first : {0U, 1U, 4U, 9U}) {
        CHECK(spread_first(4, first) == Order{0, 1, 2, 3});
    }
    CHECK(spread_first(0, 6).empty());
}

TEST_CASE("an interrupted run compares no more") {
    const Ledger ledger = parse_ledger(
        small_ledger::head + "[[claim]]\nid = \"C\"\nkind = \"value\"\nover = \"hertz\"\n"
                             "of = \"p(x)\"\nsays = \"Es*C/2*sqrt(a^2-x^2)\"\n",
        "small.toml");
    const Claim& claim = ledger.claims.front();
    const AuditContext context(ledger, 34);
    const auto spots = Spots::of(claim, context, 34);
    const Agreement agreement = spots->compare(claim.formula("says"), claim.formula("of"));
    CHECK(agreement.digits() > 29);
    request_interruption(2);
    CHECK_THROWS_AS((void)spots->compare(claim.formula("says"), claim.formula("of")), Interrupted);
    withdraw_interruption();
}
