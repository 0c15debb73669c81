// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/precision/precision.hpp"
#include "edgeproof/precision/rounding/text.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <iomanip>
#include <random>
#include <sstream>

namespace {

Rational halved(unsigned times) { return Rational(Integer(1), Integer(Integer(1) << times)); }

std::string streamed_ball(const Ball& x, int digits) {
    std::ostringstream out;
    out << std::setprecision(digits) << x;
    return out.str();
}

} // namespace

TEST_CASE("a decimal means exactly the number that is written") {
    CHECK(parse_decimal("0.4") == Rational(2, 5));
    CHECK(parse_decimal("-1.25e2") == -125);
    CHECK(parse_decimal("1e-3") == Rational(1, 1000));
    CHECK(parse_decimal(".5") == Rational(1, 2));
    CHECK(parse_decimal("3/2") == Rational(3, 2));
    CHECK(parse_decimal("+7") == 7);
    CHECK(parse_decimal("000") == 0);
    CHECK(parse_decimal("0.1") + parse_decimal("0.2") == parse_decimal("0.3"));
    for (const char* bad : {"", "-", ".", "e5", "1e", "1e+", "0x10", "inf", "nan", "1.2.3", "1 2",
                            "1/0", "1/-2", "1/2/3", "2*3", "1e100001", "1e99999999999999999999"}) {
        CAPTURE(bad);
        CHECK_THROWS_AS((void)parse_decimal(bad), InputError);
    }
}

TEST_CASE("written digits are correctly rounded: judged in exact rationals") {
    std::mt19937_64 seeded(7);
    std::uniform_real_distribution<double> uniform(-40, 40);
    for (int k = 0; k < 500; ++k) {
        const PrecisionScope scope(60);
        const Real x = exp(Real(uniform(seeded)) * 3) * (k % 2 == 0 ? 1 : -1);
        const unsigned digits = 1 + static_cast<unsigned>(k) % 45;
        const Rational exact(x);
        const Rational written = parse_decimal(to_decimal(x, digits));
        // One unit of the last digit of the text.
        const Real magnitude = floor(log10(abs(x)));
        const int last = static_cast<int>(magnitude) - static_cast<int>(digits) + 1;
        const Rational unit =
            last < 0 ? Rational(1) / Rational(pow(Integer(10), static_cast<unsigned>(-last)))
                     : Rational(pow(Integer(10), static_cast<unsigned>(last)));
        CHECK(abs(Rational(written - exact)) * 2 <= unit);
    }
}

TEST_CASE("the layout is canonical") {
    CHECK(to_decimal(Real(0), 10) == "0");
    CHECK(to_decimal(Real(1), 3) == "1.00");
    CHECK(to_decimal(Real(-125), 3) == "-125");
    CHECK(to_decimal(Real(125), 2) == "1.2e+02"); // the tie goes to even
    CHECK(to_decimal(Real(135), 2) == "1.4e+02");
    CHECK(to_decimal(Real("0.0001220703125"), 4) == "0.0001221");
    CHECK(to_decimal(ldexp(Real(1), -40), 3) == "9.09e-13");
    CHECK(bound_text(ldexp(Real(1), -40)) == "9.1e-13");
    CHECK(bound_text(Real(0)) == "0");
    CHECK(exact_text(Rational(1, 8)) == "0.125");
    CHECK(exact_text(Rational(-3)) == "-3");
    CHECK(exact_text(Rational(0)) == "0");
    CHECK(exact_text(Rational(1200)) == "1200");
    CHECK(exact_text(Rational(-5, 2)) == "-2.5");
    CHECK(exact_text(Rational(1, 3)) == "1/3");
    CHECK(exact_text(Rational(-1, 2000)) == "-0.0005");
}

TEST_CASE("an exact number is rounded once, each way") {
    const auto text = [](const char* q, unsigned digits, Rounding mode) {
        return to_decimal(parse_decimal(q), digits, mode);
    };
    CHECK(text("1/3", 5, Rounding::nearest) == "0.33333");
    CHECK(text("1/3", 5, Rounding::up) == "0.33334");
    CHECK(text("-1/3", 5, Rounding::up) == "-0.33333");
    CHECK(text("-1/3", 5, Rounding::down) == "-0.33334");
    CHECK(text("9.995", 3, Rounding::nearest) == "10.0"); // the tie goes to even
    CHECK(text("9.985", 3, Rounding::nearest) == "9.98");
    CHECK(text("999.9", 3, Rounding::up) == "1.00e+03");
    CHECK(text("0.9", 4, Rounding::down) == "0.9000");
    CHECK(text("0.9", 4, Rounding::up) == "0.9000");
    CHECK(text("0", 4, Rounding::nearest) == "0");
    CHECK(text("123456789", 4, Rounding::down) == "1.234e+08");
    CHECK_THROWS_AS((void)text("1", 0, Rounding::nearest), DomainError);
    // MPFR converts by another method.
    std::mt19937_64 seeded(11);
    std::uniform_int_distribution<int> whole(1, 1'000'000);
    for (int k = 0; k < 300; ++k) {
        const Rational q(whole(seeded), whole(seeded));
        const PrecisionScope scope(120);
        Real x;
        mpfr_set_q(x.backend().data(), q.backend().data(), MPFR_RNDN);
        const unsigned digits = 1 + static_cast<unsigned>(k) % 30;
        if (Rational(x) != q) { // otherwise x may be a tie
            CHECK(to_decimal(q, digits, Rounding::nearest) == to_decimal(x, digits));
        }
    }
}

TEST_CASE("a ball is printed only as far as every number in it agrees") {
    const long bits = 400;
    const Ball third(Rational(1, 3), bits);
    CHECK(round_ball(third, 20).text == "0.33333333333333333333");
    CHECK(round_ball(third, 20).complete);
    CHECK(round_ball(third, 3, Rounding::up).text == "0.334");
    CHECK(round_ball(third, 3, Rounding::down).text == "0.333");
    CHECK(round_ball(-third, 3, Rounding::down).text == "-0.334");
    // 60 digits agree before the boundary: 0.25 + 1e-60 must not round like 0.25.
    const Rational hair = Rational(1) / Rational(pow(Integer(10), 60));
    CHECK(round_ball(Ball(Rational(Rational(25, 100) + hair), bits), 1).text == "0.3");
    CHECK(round_ball(Ball(Rational(Rational(25, 100) - hair), bits), 1).text == "0.2");
    CHECK(round_ball(Ball(Rational(25, 100), bits), 1).text == "0.2"); // an exact tie, to even
    // A wide ball has fewer certain digits.
    const Ball wide = Ball::around(Real(1234567), Real(1), 100);
    const Rounded r = round_ball(wide, 10);
    CHECK_FALSE(r.complete);
    CHECK(r.digits == 6);
    CHECK(r.text == "1.23457e+06");
    CHECK(round_ball(Ball::around(Real(0), Real(1), 100), 5).digits == 0);
}

TEST_CASE("a printed number comes with the value of its text") {
    std::mt19937_64 seeded(29);
    std::uniform_int_distribution<int> whole(-1'000'000, 1'000'000);
    std::uniform_int_distribution<int> place(-40, 40);
    for (int k = 0; k < 2000; ++k) {
        const int at = place(seeded);
        const Rational ten = Rational(pow(Integer(10), static_cast<unsigned>(std::abs(at))));
        const Rational q = Rational(whole(seeded), 1 + std::abs(whole(seeded))) *
                           (at < 0 ? Rational(1 / ten) : ten);
        const unsigned digits = 1 + static_cast<unsigned>(k) % 12;
        CAPTURE(q.str());
        for (const Rounding mode : {Rounding::nearest, Rounding::down, Rounding::up}) {
            const Rounded r = round_rational(q, digits, mode);
            CHECK(r.value.value() == parse_decimal(r.text));
        }
        CHECK(round_rational(q, digits, Rounding::down).value.value() <= q);
        CHECK(round_rational(q, digits, Rounding::up).value.value() >= q);
        const Rounded ball = round_ball(Ball(q, 200), digits, Rounding::nearest);
        if (q != 0) {
            CHECK(ball.value.value() == parse_decimal(ball.text));
        }
    }
    CHECK(round_rational(Rational(0), 3, Rounding::nearest).text == "0");
    CHECK(round_rational(Rational(0), 3, Rounding::nearest).value.value() == 0);
    CHECK_THROWS_AS((void)(Decimal{false, "1", 10000001}.value()), InputError);
}

TEST_CASE("a ball has all digits if both its ends, as rationals, round to them") {
    const std::vector<Rounding> modes{Rounding::nearest, Rounding::down, Rounding::up};
    // Wide balls, and balls around ties, whole units and powers of ten.
    std::mt19937_64 seeded(23);
    std::uniform_int_distribution<int> whole(1, 1'000'000);
    std::uniform_int_distribution<int> place(-400, 400);
    std::size_t alike = 0;
    for (int k = 0; k < 3000; ++k) {
        const unsigned digits = 1 + static_cast<unsigned>(k) % 60;
        const int at = k % 3 == 0 ? 0 : place(seeded);
        const Rational ten = Rational(pow(Integer(10), static_cast<unsigned>(std::abs(at))));
        Rational middle(k % 5 == 0   ? 10 * whole(seeded) + 5
                        : k % 7 == 0 ? 1000
                                     : whole(seeded),
                        k % 2 == 0 ? 1 : whole(seeded));
        middle *= at < 0 ? Rational(1 / ten) : ten;
        middle *= k % 4 == 0 ? -1 : 1;
        const long bits = 260;
        const Rational radius = abs(middle) * halved(static_cast<unsigned>(20 + k % 230));
        const PrecisionScope scope(100);
        const Ball x =
            Ball(middle, bits) + Ball::from_interval(Real(-1), Real(1), bits) * Ball(radius, bits);
        for (const Rounding mode : modes) {
            // Rounds the ends as rational numbers, an independent method.
            const Rational from = Rational(x.midpoint()) - Rational(x.radius());
            const Rational to = Rational(x.midpoint()) + Rational(x.radius());
            const std::string text = to_decimal(from, digits, mode);
            const bool complete = text == to_decimal(to, digits, mode);
            CAPTURE(to_decimal(middle, 30, Rounding::nearest));
            CAPTURE(digits);
            CHECK(round_ball(x, digits, mode).complete == complete);
            CHECK((!complete || round_ball(x, digits, mode).text == text));
            alike += complete ? 1 : 0;
        }
    }
    CHECK(alike > 3000);
}

TEST_CASE("a bound of two digits is the least that is not below: judged in exact rationals") {
    std::mt19937_64 seeded(41);
    std::uniform_real_distribution<double> uniform(-700, 700);
    const PrecisionScope scope(60);
    for (int k = 0; k < 3000; ++k) {
        Real x = exp(Real(uniform(seeded)) * (k % 10 == 0 ? 100 : 1));
        if (k % 3 == 0) { // near a number of two digits
            x = Real(parse_decimal(bound_text(x))) *
                (1 + (k % 2 == 0 ? 1 : -1) * ldexp(Real(1), -k % 190));
        }
        CHECK(bound_text(x) == to_decimal(Rational(x), 2, Rounding::up));
    }
}

TEST_CASE("the binary64 of a ball is that of both its ends") {
    std::mt19937_64 seeded(43);
    std::uniform_real_distribution<double> uniform(-740, 700);
    for (int k = 0; k < 3000; ++k) {
        const PrecisionScope scope(60);
        Real middle = exp(Real(uniform(seeded)));
        if (k % 4 == 0) { // almost halfway between two
            const double x = middle.convert_to<double>();
            middle = (Real(x) + Real(std::nextafter(x, 2 * x))) / 2;
        }
        const Ball x =
            Ball::around(k % 2 == 0 ? middle : -middle, ldexp(middle, -40 - k % 130), 260);
        const double lower =
            nearest_binary64(Rational(Rational(x.midpoint()) - Rational(x.radius())));
        const double upper =
            nearest_binary64(Rational(Rational(x.midpoint()) + Rational(x.radius())));
        const auto found = nearest_binary64(x);
        CHECK(found.has_value() == (lower == upper));
        CHECK((!found || *found == lower));
    }
}

TEST_CASE("the nearest binary64, once") {
    CHECK(nearest_binary64(Ball(Rational(1, 3), 200)).value() == 1.0 / 3.0);
    CHECK_FALSE(nearest_binary64(Ball::around(Real(1), Real("1e-10"), 100)).has_value());
    // Slightly above the middle between 1 and its successor: rounding twice would round down.
    const Rational half = Rational(1) + halved(53);
    const Rational hair = halved(200);
    CHECK(nearest_binary64(Ball(Rational(half + hair), 400)).value() == std::nextafter(1.0, 2.0));
    CHECK(nearest_binary64(Ball(half, 400)).value() == 1.0);
    // Subnormals round on their own grid.
    const Rational tiny = halved(1074);
    CHECK(nearest_binary64(Ball(Rational(tiny * Rational(7, 5)), 400)).value() == 0x1p-1074);
    CHECK(nearest_binary64(Ball(Rational(tiny * Rational(8, 5)), 400)).value() == 0x1p-1073);
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

// pi = 3.14159265358979323846..., so that |3.14159 - pi| = 2.6535...e-6 and |3.1415926536 - pi| =
// 1.0206...e-11.
TEST_CASE("a ball is printed with the digits of the stream and the bound of their error") {
    std::ostringstream out;
    out << Ball::pi(200);
    CHECK(out.str() == "3.14159 +/- 2.7e-06");
    CHECK(streamed_ball(Ball::pi(200), 11) == "3.1415926536 +/- 1.1e-11");
    // The radius of such a ball is at most 2^-100 = 7.9e-31.
    CHECK(streamed_ball(Ball(Rational(3, 10), 100), 4).substr(0, 11) == "0.3000 +/- ");
    CHECK(streamed_ball(Ball(Rational(3, 10), 100), 4).substr(14) == "e-31");
    CHECK(streamed_ball(-Ball(2, 64), 3) == "-2.00 +/- 0");
    CHECK(streamed_ball(Ball(0, 64), 3) == "0 +/- 0");
}

TEST_CASE("a wide ball has fewer digits, or both ends") {
    // Both ends, 1.249023... and 1.250976..., round to 1.25, but not to the same four digits.
    const Ball wide = Ball::around(Real(1.25), Real(0x1p-10), 64);
    CHECK(streamed_ball(wide, 10) == "1.25 +/- 0.00098");
    CHECK(streamed_ball(Ball::around(Real(0), Real(0.25), 64), 10).substr(0, 4) == "[-0.");
    CHECK(streamed_ball(1 / Ball(0, 64), 10) == "nan");
}
