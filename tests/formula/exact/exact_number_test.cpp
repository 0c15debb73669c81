// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/formula/exact/exact_number.hpp"

#include "edgeproof/formula/parse.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <string>

namespace {

ExactNumber number(const std::string& text) { return ExactNumber::of(parse(text)); }

} // namespace

TEST_CASE("exact numbers: zeros by an identity of roots and of pi") {
    for (const char* text :
         {"sqrt(2)*sqrt(3) - sqrt(6)", "sqrt(8) - 2*sqrt(2)", "(1 + sqrt(2))^2 - 3 - 2*sqrt(2)",
          "sqrt(2)*sqrt(2) - 2", "2^(1/3)*4^(1/3) - 2", "16^(1/6) - 4^(1/3)",
          "sqrt(1/3) - sqrt(3)/3", "(sqrt(5) + sqrt(7))*(sqrt(5) - sqrt(7)) + 2", "sqrt(pi^2) - pi",
          "sqrt(pi)*sqrt(pi*4) - 2*pi", "sqrt(sqrt(16/81)) - 2/3", "(pi + 1)*(pi - 1) - pi^2 + 1",
          "abs(1 - sqrt(2)) - sqrt(2) + 1", "2^(-1/2) - sqrt(2)/2"}) {
        CAPTURE(text);
        CHECK(number(text).is_zero());
        CHECK(number(text).sign() == 0);
    }
}

TEST_CASE(
    "exact numbers: numbers that are not zero, but cannot be distinguished from zero in balls") {
    // Numbers near zero: sqrt(2) minus its first 60 digits; the same for pi; classical sums of
    // roots such as sqrt(10) + sqrt(11) - sqrt(5) - sqrt(18).
    for (const char* text : {
             "sqrt(2) - 1.41421356237309504880168872420969807856967187537694807317667",
             "pi - 3.14159265358979323846264338327950288419716939937510582097494",
             "pi^2 - 9.8696044010893586188344909998761511353136994072407906264133",
             "sqrt(10) + sqrt(11) - sqrt(5) - sqrt(18)",
             "2^(1/3) - sqrt(2)",
         }) {
        CAPTURE(text);
        CHECK(number(text).known());
        CHECK_FALSE(number(text).is_zero());
        CHECK(number(text).sign() != 0);
        CHECK_FALSE(number(text).rational());
    }
}

TEST_CASE("exact numbers: rational ones are recognised, others are unknown") {
    CHECK(number("sqrt(2)*sqrt(8)").rational() == Rational(4));
    CHECK(number("(9/4)^(3/2)").rational() == Rational(27, 8));
    CHECK(number("pi*3/(2*pi)").rational() == Rational(3, 2));
    CHECK(number("0*pi").rational() == Rational(0));
    CHECK(number("(-2)^3").rational() == Rational(-8));
    for (const char* text :
         {"log(2)", "1/(1 + sqrt(2))", "sqrt(1 + sqrt(2))", "sqrt(1 - pi)", "2^(1/97)",
          "1/(sqrt(2)*sqrt(2) - 2)", "2^pi", "log(2) - log(2)", "0*log(2)"}) {
        CAPTURE(text);
        CHECK_FALSE(number(text).known());
        CHECK_FALSE(number(text).is_zero());
        CHECK_FALSE(number(text).rational());
        CHECK_FALSE(number(text) == number(text));
    }
}

TEST_CASE("exact numbers: enclosures hold what Arb finds of the same expression") {
    const ExactNumber x = number("3*sqrt(2)*pi - 5^(1/3)/pi + 7");
    const Ball two(2, 200);
    const Ball expected =
        3 * sqrt(two) * Ball::pi(200) - pow(Ball(5, 200), Rational(1, 3)) / Ball::pi(200) + 7;
    CHECK(overlaps(x.enclosure(200), expected));
    CHECK(x.enclosure(200).relative_accuracy_bits() > 180);
    CHECK(x.sign() == 1);
    CHECK(ExactNumber(-x).sign() == -1);
}

TEST_CASE("exact numbers: angles by their cosines") {
    struct Row {
        const char* cosine;
        Rational of_pi;
    };
    // Cosines of multiples of 15 degrees from tables.
    for (const Row& row :
         {Row{"1", Rational(0)}, Row{"(sqrt(6) + sqrt(2))/4", Rational(1, 12)},
          Row{"sqrt(3)/2", Rational(1, 6)}, Row{"sqrt(1/2)", Rational(1, 4)},
          Row{"1/2", Rational(1, 3)}, Row{"(sqrt(6) - sqrt(2))/4", Rational(5, 12)},
          Row{"0", Rational(1, 2)}, Row{"(sqrt(2) - sqrt(6))/4", Rational(7, 12)},
          Row{"-1/2", Rational(2, 3)}, Row{"-sqrt(2)/2", Rational(3, 4)},
          Row{"-sqrt(3)/2", Rational(5, 6)}, Row{"-1", Rational(1)}}) {
        CAPTURE(row.cosine);
        CHECK(angle_of_cosine(number(row.cosine)) == ExactNumber(row.of_pi) * ExactNumber::pi());
    }
    for (const char* text : {"1/3", "sqrt(1/3)", "pi/4", "-0.5000000000000000000000000001"}) {
        CHECK_FALSE(angle_of_cosine(number(text)).known());
    }
}
