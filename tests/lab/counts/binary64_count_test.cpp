// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/precision/error.hpp"
#include "lab/counts/binary64_count.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

using namespace edgeproof;

namespace {

Binary64Options options(std::uint64_t seed, std::size_t values) {
    Binary64Options o;
    o.seed = seed;
    o.values = values;
    o.threads = 1;
    return o;
}
using Count = CountResult<std::string>;

} // namespace

TEST_CASE(
    "a hundred thousand pressures in double words, on corners too: none wrong, 1 in 10^5 left to "
    "balls at most") {
    const Count count = count_binary64(options(3, 100'000));
    CHECK(count.contacts == 10);
    CHECK(count.total.values == 100'000);
    CHECK(count.total.wrong == 0);
    CHECK(count.findings.empty());
    CHECK(count.total.undecided <= 1);
    CHECK(count.cells.size() == drawn_places.size());
    for (const auto& [number, cell] : count.cells) {
        CHECK(cell.values > 500);
    }
}

TEST_CASE("the same values for the same seed, others for another") {
    const Count one = count_binary64(options(3, 2000));
    CHECK(one.cells.at(0).values == count_binary64(options(3, 2000)).cells.at(0).values);
    CHECK(one.cells.at(0).values != count_binary64(options(4, 2000)).cells.at(0).values);
}

TEST_CASE("a value that is off by more than its bound is counted as wrong") {
    Binary64Options o = options(5, 2000);
    o.changed = [](DoubleWord& x) { x.low += 0x1p-56 * x.high; };
    const Count count = count_binary64(o);
    CHECK(count.total.wrong > 100);
    CHECK(count.findings.size() == count.total.wrong);
}
