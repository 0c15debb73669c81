// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/precision/rounding/digits_right.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

TEST_CASE("digits that are right: against the worst number of the ball") {
    const PrecisionScope scope(60);
    CHECK(digits_right(Real(1), Ball(Rational(1), 200)) == most_digits_right);
    CHECK(digits_right(Real(1) + pow(Real(10), -7) * 2, Ball(Rational(1), 200)) == 6);
    CHECK(digits_right(Real(1), Ball::around(Real(1), pow(Real(10), -9) * 3, 200)) == 8);
    CHECK(digits_right(Real(2), Ball(Rational(1), 200)) == 0);
    CHECK(digits_right(Real(0) / Real(0), Ball(Rational(1), 200)) == 0);
    CHECK(digits_proved(Ball::around(Real(2), pow(Real(10), -9), 200)) == 9);
}

TEST_CASE("digits are those of the true error, and no more than the enclosure proves") {
    const PrecisionScope scope(60);
    const Real one(1);
    const Ball narrow = Ball::around(one, pow(Real(10), -50), 200);
    CHECK(digits_reached(Real(one + pow(Real(10), -10)), narrow) ==
          doctest::Approx(10).epsilon(1e-6));
    CHECK(digits_reached(Real(one - 3 * pow(Real(10), -7)), narrow) ==
          doctest::Approx(6.5229).epsilon(1e-4));
    CHECK(digits_reached(one, narrow) == doctest::Approx(50).epsilon(1e-3));
    CHECK(digits_reached(Real(-one), narrow) == 0);
    CHECK(digits_reached(one, Ball::around(Real(0), one, 200)) == 0);
    Real none(0);
    mpfr_set_nan(none.backend().data());
    CHECK(digits_reached(none, narrow) == 0);
}
