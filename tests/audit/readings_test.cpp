// SPDX-License-Identifier: BSD-3-Clause
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

} // namespace

TEST_CASE("readings: all hold, some hold, none holds, some are undecided") {
    const std::pair<std::vector<Judgement>, Verdict> combined[] = {
        {{proved, proved}, Verdict::proved},
        {{proved, confirmed}, Verdict::confirmed},
        {{confirmed, refuted}, Verdict::imprecise},
        {{refuted, confirmed, imprecise}, Verdict::imprecise},
        {{refuted, refuted}, Verdict::refuted},
        // An unlikely reading that is nearly right does not save a claim that the plain reading
        // refutes.
        {{refuted, imprecise}, Verdict::refuted},
        {{imprecise, refuted}, Verdict::imprecise},
        {{}, Verdict::undecided},
        {{confirmed, undecided}, Verdict::undecided},
        {{refuted, undecided}, Verdict::undecided},
        {{underspecified, underspecified}, Verdict::underspecified},
    };
    for (const auto& [readings, verdict] : combined) {
        CHECK(Judgement::of_readings(readings) == verdict);
    }
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
