// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/validation/binary64_count.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

using namespace edgeproof;

TEST_CASE("a hundred thousand pressures in double words: none wrong, few left to balls") {
    const Binary64Count count = count_binary64(3, 100'000);
    CHECK(count.contacts == 10);
    CHECK(count.total().values == 100'000);
    CHECK(count.total().wrong == 0);
    CHECK(count.findings.empty());
    // 1 in 10^4 but by knots, where p is infinite on a corner and the sample comes that near.
    const auto undecided = [&](DrawnPlace place) {
        return count.cells.at(static_cast<std::size_t>(place)).undecided;
    };
    CHECK(undecided(DrawnPlace::by_the_edge) <= 3);
    CHECK(undecided(DrawnPlace::inside) <= 3);
    CHECK(undecided(DrawnPlace::by_a_knot) < 1000);
}

TEST_CASE("the same places for the same seed, others for another") {
    CHECK(count_binary64(3, 30'000).total().undecided ==
          count_binary64(3, 30'000).total().undecided);
    CHECK(count_binary64(3, 30'000).cells[0].values != count_binary64(4, 30'000).cells[0].values);
}
