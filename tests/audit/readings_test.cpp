// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/run.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

namespace {

const Ball one(1, 64);
const Ball two(2, 64);
const Judgement refuted(*Refutation::less(one, two));
const Judgement confirmed(*Confirmation::less(one, two));
const Judgement imprecise = Judgement::imprecise(*Confirmation::less(one, two));
const Judgement proved = Judgement::proved_by_symbols();
const Judgement undecided;
const Judgement underspecified = Judgement::underspecified();

Judgement combine_readings(const std::vector<Judgement>& readings) {
    return Judgement::of_readings(readings);
}

} // namespace

TEST_CASE("readings: all hold, some hold, none holds") {
    CHECK(combine_readings({proved, proved}) == Verdict::proved);
    CHECK(combine_readings({proved, confirmed}) == Verdict::confirmed);
    CHECK(combine_readings({confirmed, refuted}) == Verdict::imprecise);
    CHECK(combine_readings({refuted, confirmed, imprecise}) == Verdict::imprecise);
    CHECK(combine_readings({refuted, refuted}) == Verdict::refuted);
    // An unlikely reading that is nearly right does not save a claim that the plain reading
    // refutes.
    CHECK(combine_readings({refuted, imprecise}) == Verdict::refuted);
    CHECK(combine_readings({imprecise, refuted}) == Verdict::imprecise);
}

TEST_CASE("readings: an undecided reading leaves the claim undecided") {
    CHECK(combine_readings({}) == Verdict::undecided);
    CHECK(combine_readings({undecided}) == Verdict::undecided);
    CHECK(combine_readings({confirmed, undecided}) == Verdict::undecided);
    CHECK(combine_readings({refuted, undecided}) == Verdict::undecided);
    CHECK(combine_readings({underspecified, underspecified}) == Verdict::underspecified);
}

TEST_CASE("patterns of ids") {
    CHECK(matches("*", "EQ01"));
    CHECK(matches("EQ2*", "EQ24.N"));
    CHECK(matches("EQ?4.N", "EQ24.N"));
    CHECK_FALSE(matches("EQ2", "EQ24"));
    CHECK_FALSE(matches("eq2*", "EQ24"));
    std::string stars; // a naive search would try 2^30 ways and more
    for (int k = 0; k < 30; ++k) {
        stars += "*a";
    }
    CHECK_FALSE(matches(stars + "b", std::string(100, 'a')));
}
