// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/conformance/causes/self_test.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace {

using edgeproof::conformance::test_causes;
using edgeproof::scene::MistakeCounts;
using edgeproof::scene::MistakeRow;

void check_causes_named(const MistakeCounts& counts) {
    for (const std::string& miss : counts.misses) {
        MESSAGE(miss);
    }
    const auto sum = counts.total();
    CHECK(sum.wrong == 0);
    CHECK(sum.cases > 50);
    CHECK(counts.passes(90));
}

} // namespace

TEST_CASE("the test of the causes: mistakes are named under noise, and none wrongly" *
          doctest::test_suite("slow")) {
    const MistakeCounts counts = test_causes(7, 0, {"two cylinders, P given"});
    check_causes_named(counts);
    const auto row = [&](const std::string& name) {
        const auto found = std::ranges::find(counts.rows, name, &MistakeRow::name);
        REQUIRE(found != counts.rows.end());
        return *found;
    };
    CHECK(counts.contacts == 1);
    CHECK(row("cancellation").at[0].named == 1);
    CHECK(row("sum-of-moduli").at[2].named == 2); // 0.1 % of noise: not called a factor pi
    CHECK(row("plane-stress").at[2].named == 1);
    CHECK(row("x-for-u").at[0].named == 1);
    CHECK(row("").at[4].named == 3); // right answers and two smooth errors, 5 % of noise
}

TEST_CASE("the test of the causes: noise by which wrong causes were named once" *
          doctest::test_suite("slow")) {
    const std::pair<std::uint64_t, std::vector<std::string>> draws[] = {
        // sqrt(2) and a smooth rest, with 5 % of noise
        {91102, {"a wedge", "a piecewise linear profile"}},
        // sqrt(2) and a rest of just over a tenth; the noise of 12 answers has a mean of 4
        // deviations
        {12, {"a cylinder, a given", "a flat with rounded edges, a given"}},
        // 1.37 near sqrt(2): the constant is added to the named causes
        {300003, {"two spheres"}},
        // the noise of p has a mean of several deviations; c_k has the cause
        {600005, {"two spheres"}},
        // 12 answers that noise spreads over 3.5 deviations
        {300002, {"a cylinder, full stick"}},
        // two answers of 5 digits with the same error
        {500004, {"a cylinder, full stick"}},
    };
    for (const auto& [seed, contacts] : draws) {
        const MistakeCounts counts = test_causes(seed, 0, contacts);
        check_causes_named(counts);
        CHECK(counts.contacts == contacts.size());
    }
}

TEST_CASE("the test of the causes on all contacts" * doctest::test_suite("slow")) {
    for (const std::uint64_t seed : {11, 12, 13}) {
        CAPTURE(seed);
        const MistakeCounts counts = test_causes(seed);
        check_causes_named(counts);
        CHECK(counts.contacts == 13);
    }
}
