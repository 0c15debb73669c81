// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/design/edge_function.hpp"
#include "edgeproof/precision/ball/acb_include.hpp"
#include "edgeproof/precision/ball/arb_include.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <string>

using namespace edgeproof;
using namespace edgeproof::contact;

namespace {

/// Returns 2F1(1, b; 3/2; y) by Arb's own function, which chooses among transformations.
Ball by_arb(const Rational& b, const Rational& y, long bits) {
    Ball f(0, bits);
    arb_hypgeom_2f1(f.data(), Ball(1, bits).data(), Ball(b, bits).data(),
                    Ball(Rational(3, 2), bits).data(), Ball(y, bits).data(), 0, bits);
    return f;
}

} // namespace

TEST_CASE(
    "the kept sum of the edge's series holds Gauss's function, narrowly, for one b after another") {
    EdgeSum sum;
    for (const long bits : {64L, 200L, 700L}) {
        for (const std::string b : {"0", "1/2", "-1/2", "-1", "-7/3", "99/100", "1/2"}) {
            for (const std::string y : {"1/1000", "1/2", "4/5", "1/7", "-1/3"}) {
                CAPTURE(bits);
                CAPTURE(b);
                CAPTURE(y);
                const Rational exact_b(b);
                const Rational exact_y(y);
                const auto f = sum(Ball(exact_b, bits), Ball(exact_y, bits));
                REQUIRE(f);
                // Use many more bits than the sum, so that an omitted part would show.
                CHECK(contains(*f, by_arb(exact_b, exact_y, 2 * bits + 100).midpoint()));
                CHECK(f->relative_accuracy_bits() > bits - 40);
            }
        }
    }
}

TEST_CASE(
    "the kept sum holds the values at both ends of a wide y, and takes no b that may reach 1") {
    EdgeSum sum;
    const Ball wide = Ball::hull(Ball(Rational(1, 4), 128), Ball(Rational(1, 2), 128));
    const auto f = sum(Ball(Rational(1, 2), 128), wide);
    REQUIRE(f);
    for (const char* y : {"1/4", "2/5", "1/2"}) {
        CHECK(contains(*f, by_arb(Rational(1, 2), Rational(y), 256).midpoint()));
    }
    const auto at_zero = sum(Ball(Rational(1, 2), 128), Ball(0, 128));
    REQUIRE(at_zero);
    CHECK(contains(*at_zero, Rational(1)));
    CHECK_FALSE(sum(Ball(1, 128), Ball(Rational(1, 2), 128)));
    CHECK_FALSE(sum(Ball(Rational(1, 2), 128), Ball(Rational(9999, 10000), 128)));
    CHECK_FALSE(sum(Ball(Rational(1, 2), 128), Ball(1, 128)));
}
