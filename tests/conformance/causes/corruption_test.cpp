// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/conformance/causes/self_test.hpp"
#include "edgeproof/precision/error.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <set>

namespace {

const std::string right = "id,quantity,edge,u,value\n"
                          "w:left:u=1:p,p,left,1,0.123456789012345678\n"
                          "w:left:u=2:p,p,left,2,0.223456789012345678\n"
                          "w:right:u=1:p,p,right,1,0.323456789012345678\n"
                          "w:right:u=2:p,p,right,2,-0.423456789012345678\n"
                          "w:P,P,,,7.5\n";

} // namespace

TEST_CASE("corrupted files: there are all kinds, each differs from the right file, the same seed "
          "gives the same") {
    const Csv csv = parse_csv(right, "a.csv");
    CHECK(csv_text(csv) == right);
    const auto list = corruptions(csv, 5, 100);
    REQUIRE(list.size() == 100);
    std::set<std::string> kinds;
    for (const Corruption& corrupted : list) {
        kinds.insert(corrupted.kind);
        CAPTURE(corrupted.kind);
        CHECK(corrupted.text != right);
        CHECK_FALSE(corrupted.what.empty());
    }
    CHECK(kinds.size() == 26);
    const auto again = corruptions(csv, 5, 100);
    CHECK(again[99].text == list[99].text);
    CHECK(corruptions(csv, 6, 100)[0].text + corruptions(csv, 6, 100)[1].text !=
          list[0].text + list[1].text);
    CHECK_THROWS_AS((void)corruptions(parse_csv("id,value\n1,2\n", "a.csv"), 1, 1), InputError);
}

TEST_CASE("left and right are exchanged only where that changes anything") {
    const Csv same = parse_csv("id,quantity,edge,u,value\nw:left:u=1:p,p,left,1,0.5\n"
                               "w:right:u=1:p,p,right,1,0.5\nw:P,P,,,0.25\n",
                               "a.csv");
    std::size_t exchanged = 0;
    for (const Corruption& corrupted : corruptions(same, 1, 60)) {
        exchanged += corrupted.kind == "left and right exchanged" ? 1 : 0;
    }
    CHECK(exchanged == 0);
}
