// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/precision/error.hpp"
#include "lab/counts/binary64_count.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

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
    "a hundred thousand values in double words, on corners too: none wrong, 1 in 10^5 left to "
    "balls at most") {
    const Count count = count_binary64(options(3, 100'000));
    CHECK(count.contacts == 10);
    CHECK(count.total.values == 100'000);
    CHECK(count.total.wrong == 0);
    CHECK(count.findings.empty());
    CHECK(count.total.undecided <= 1);
    CHECK(count.cells.size() == drawn_forms.size() * drawn_places.size());
    for (const auto& [number, cell] : count.cells) {
        CHECK(cell.values > 500);
    }
}

TEST_CASE(
    "q in a stick zone on a corner that algebra cannot recognise is compared with both sides") {
    // A tilted wedge with b = 5 only enclosed; five of its places are u = 5, the apex.
    const CountedContact<std::string> found =
        count_binary64_contact(options(11, 10'000), 7969, 10'000);
    CHECK(found.findings.empty());
    Binary64Options wrong = options(11, 10'000);
    wrong.changed = [](DoubleWord& word) { word.high = std::nextafter(word.high, 1e300); };
    const std::vector<std::string> findings = count_binary64_contact(wrong, 7969, 10'000).findings;
    CHECK(std::ranges::any_of(findings, [](const std::string& finding) {
        return finding.find("q, partial slip") != std::string::npos &&
               finding.find("at u = 0x1.4p+2 from the left edge") != std::string::npos;
    }));
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
