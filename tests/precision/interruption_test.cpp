// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/precision/interruption.hpp"

#include "edgeproof/precision/error.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <exception>
#include <type_traits>

TEST_CASE("an interruption is thrown while it is requested; its first reason remains") {
    CHECK(interruption_requested() == 0);
    CHECK_NOTHROW(check_interruption());
    request_interruption(15);
    request_interruption(2);
    CHECK(interruption_requested() == 15);
    CHECK_THROWS_AS(check_interruption(), Interrupted);
    withdraw_interruption();
    CHECK_NOTHROW(check_interruption());
}

TEST_CASE("nothing that catches errors catches an interruption") {
    CHECK_FALSE(std::is_base_of_v<Error, Interrupted>);
    CHECK_FALSE(std::is_base_of_v<std::exception, Interrupted>);
}
