// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/run.hpp"

#include <doctest/doctest.h>

using namespace edgeproof;
using enum Verdict;

TEST_CASE("readings: all hold, some hold, none holds") {
    CHECK(combine_readings({proved, proved}) == proved);
    CHECK(combine_readings({proved, confirmed}) == confirmed);
    CHECK(combine_readings({confirmed, refuted}) == imprecise);
    CHECK(combine_readings({refuted, confirmed, imprecise}) == imprecise);
    CHECK(combine_readings({refuted, refuted}) == refuted);
    // A far-fetched reading that is nearly right does not save what the plain one refutes.
    CHECK(combine_readings({refuted, imprecise}) == refuted);
    CHECK(combine_readings({imprecise, refuted}) == imprecise);
}

TEST_CASE("readings: what is not decided decides nothing") {
    CHECK(combine_readings({}) == undecided);
    CHECK(combine_readings({undecided}) == undecided);
    CHECK(combine_readings({confirmed, undecided}) == undecided);
    CHECK(combine_readings({refuted, undecided}) == undecided);
    CHECK(combine_readings({underspecified, underspecified}) == underspecified);
}

TEST_CASE("patterns of ids") {
    CHECK(matches("*", "EQ01"));
    CHECK(matches("EQ2*", "EQ24.N"));
    CHECK(matches("EQ?4.N", "EQ24.N"));
    CHECK_FALSE(matches("EQ2", "EQ24"));
    CHECK_FALSE(matches("eq2*", "EQ24"));
}
