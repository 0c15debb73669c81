// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/precision/bounded_cache.hpp"

#include "edgeproof/precision/error.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <memory>

namespace {

/// Stores squares of numbers, and counts how many it computes.
struct Squares {
    BoundedCache<int, const int> cache{3};
    int made = 0;
    std::shared_ptr<const int> of(int k) {
        return cache.get(k, [&] {
            ++made;
            return std::make_shared<const int>(k * k);
        });
    }
};

} // namespace

TEST_CASE(
    "a cache keeps no more than its limit; a value in use remains valid after it is dropped") {
    Squares squares;
    const std::shared_ptr<const int> held = squares.of(7);
    for (const int k : {2, 3, 7}) {
        CHECK(*squares.of(k) == k * k);
    }
    CHECK(squares.made == 3);
    CHECK(*squares.of(4) == 16); // the others are dropped
    CHECK(*held == 49);
    CHECK(squares.of(7) != held);
    CHECK(squares.made == 5);
}

TEST_CASE("a value whose computation fails is not kept; a computation may request another value") {
    BoundedCache<int, const int> cache(2);
    const auto failing = []() -> std::shared_ptr<const int> { throw DomainError("no"); };
    CHECK_THROWS_AS((void)cache.get(1, failing), DomainError);
    const auto outer = cache.get(1, [&] {
        const auto inner = cache.get(2, [] { return std::make_shared<const int>(20); });
        return std::make_shared<const int>(*inner + 1);
    });
    CHECK(*outer == 21);
    CHECK(*cache.get(2, failing) == 20);
}
