// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/precision/split_mix.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <cstdint>
#include <initializer_list>

// The first numbers of Java's SplittableRandom(1234567), the generator of Steele, Lea & Flood, as
// published at rosettacode.org/wiki/Pseudo-random_numbers/Splitmix64.
TEST_CASE("SplitMix64 gives the published numbers") {
    SplitMix64 random(1234567);
    for (const std::uint64_t expected :
         {6457827717110365317U, 3203168211198807973U, 9817491932198370423U, 4593380528125082431U,
          16408922859458223821U}) {
        CHECK(random.next() == expected);
    }
    for (int i = 0; i < 1000; ++i) {
        CHECK(random.below(7) < 7);
    }
}
