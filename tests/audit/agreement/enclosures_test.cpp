// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/audit/agreement/enclosures.hpp"
#include "edgeproof/formula/exact/exact.hpp"
#include "edgeproof/precision/error.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

TEST_CASE("a pair of enclosures in the evidence") {
    const Ball third(Rational(1, 3), 100);
    const Evidence pair = pair_evidence("anywhere", "printed", third, "exact", third, 20);
    CHECK(pair["disjoint"] == false);
}

TEST_CASE("a ball's text holds all of the ball") {
    const Ball ball = Ball::around(Real(2) / 3, Real("0.001"), 200);
    CHECK(ball_text(ball, 2) == "0.67 +- 0.0044");
    CHECK(ball_text(Ball(5, 100), 3) == "5.00 +- 0");
}

TEST_CASE("a ball's text shows no digit that the ball does not know") {
    const Real thousandth = Real(1) / 1000;
    CHECK(ball_text(Ball::around(Real(1) / 8, Real(2), 200), 50) == "0 +- 2.2");
    const std::string wide = ball_text(Ball::around(Real(2) / 3, thousandth, 200), 50);
    CHECK(wide.substr(0, 10) == "0.6667 +- ");
}
