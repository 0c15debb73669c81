// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/spots.hpp"

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
