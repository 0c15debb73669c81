// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/formula/exact/exact.hpp"

#include "edgeproof/formula/parse.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

TEST_CASE("a constant means exactly the number that is written") {
    const std::pair<const char*, Rational> numbers[] = {
        {"0.4", {2, 5}},
        {" 3/2 ", {3, 2}},
        {"0.1 + 0.2", {3, 10}},
        {"sqrt(2.25)", {3, 2}},
        {"1e-30", Rational(1, Integer("1" + std::string(30, '0')))}};
    for (const auto& [text, value] : numbers) {
        CHECK(Exact::parse(text).rational() == value);
        CHECK(Exact::parse(text).text() == text);
    }
    CHECK_FALSE(Exact::parse("pi/16").is_rational());
    CHECK_THROWS_AS((void)Exact::parse("pi/16").rational(), Error);
    CHECK(Exact().rational() == 0);
    CHECK(Exact().text() == "0");
    CHECK(Exact::of(Rational(-1, 3)).text() == "-(1/3)");
    CHECK(Exact::of(Rational(1, 8)).text() == "0.125");
    CHECK(Exact(parse("Pi*2")).text() == "Pi*2");
    CHECK(Exact::parse("2*pi") == Exact::parse("2 * Pi"));
}

TEST_CASE("text that is not a constant is refused") {
    for (const char* text :
         {"", "a", "0.4.1", "1/0", "sqrt(-1)", "log(0)", "0^-1", "1/(1/3 - 1/3)", "asin(2)", "e",
          "inf", "nan", "1,5", "0,4", "1e999999999", "integral(s, s, 0, 1)", "1 2"}) {
        CAPTURE(text);
        CHECK_THROWS_AS((void)Exact::parse(text), FormulaError);
    }
    CHECK_THROWS_AS(Exact(parse("a", Symbols{"a"})), Error);
    // Balls do not decide whether these are defined.
    for (const char* text : {"1/(Pi - Pi)", "2 + log(sqrt(2)*sqrt(3) - sqrt(6))", "atan2(0, 0)"}) {
        CHECK_THROWS_AS(Exact(parse(text)), DomainError);
    }
    CHECK_THROWS_WITH_AS((void)Exact::parse("1 + 1/sin(Pi)"),
                         doctest::Contains("1/sin(Pi) has no value that can be enclosed"),
                         FormulaError);
}

TEST_CASE("values are rounded correctly") {
    CHECK(Exact::parse("0.1").to<double>() == 0.1);
    CHECK(Exact::parse("1/3").to<double>() == 1.0 / 3.0);
    CHECK(Exact::parse("pi").to<double>() == 3.141592653589793);
    CHECK(Exact::parse("sqrt(2)").to<double>() == std::sqrt(2.0)); // IEEE 754: correctly rounded
    CHECK(Exact::parse("-pi*0").to<double>() == 0.0);
    for (const unsigned digits : {10U, 50U, 500U}) {
        const PrecisionScope scope(digits);
        const std::pair<const char*, Real> values[] = {
            {"0.1", from_rational<Real>(Rational(1, 10))},
            {"sqrt(2)", sqrt(Real(2))},
            {"sqrt(8)/2", sqrt(Real(2))},
            {"exp(log(7))", Real(7)},
            {"sum(1/k, k, 1, 4)*sqrt(144)", Real(25)}};
        for (const auto& [text, number] : values) {
            CHECK(Exact::parse(text).to<Real>() == number);
        }
        for (const char* text : {"pi", "2*asin(1)", "gamma(0.5)^2", "atan2(1, -1)*4/3"}) {
            CHECK(Exact::parse(text).to<Real>() == pi<Real>());
        }
        CHECK(Exact::parse("max(3, Pi, sqrt(9.8)) + sgn(-Pi)*step(Pi)").to<Real>() ==
              Exact::parse("Pi - 1").to<Real>());
        const auto with_guard = [&] {
            const PrecisionScope more(digits + 30);
            return Real(pow(pi<Real>(), pi<Real>()));
        };
        CHECK(Exact::parse("Pi^Pi").to<Real>() == at_working_precision(with_guard()));
        CHECK(Exact::parse("sqrt(2)").to<Real>().precision() <= digits + 2);
    }
}

TEST_CASE("cancellation does not cost digits") {
    // sqrt(1 + x) - 1 - x/2 + x^2/8 = x^3/16 - 5 x^4/128 + ..., x = 1e-40.
    const PrecisionScope scope(50);
    const Real x("1e-40");
    const Real left = Exact::parse("sqrt(1 + 1e-40) - 1 - 5e-41 + 1e-80/8").to<Real>();
    const Real right = x * x * x * (Real(1) / 16 - 5 * x / 128);
    CHECK(abs(left / right - 1) < Real("1e-49"));
    CHECK(Exact::parse("sqrt(1 + 1e-40) - 1").to<double>() == 5e-41);
    CHECK(Exact::parse("Pi - 3.14159265358979323846264338327950288419716939937510").to<double>() ==
          5.8209749445923078e-51);
}

TEST_CASE("for any number of requested digits, more are used to compensate a cancellation") {
    // sqrt(1 + d) - 1 = d/(1 + sqrt(1 + d)) for d = 1e-40; the right side has no cancellation.
    const Exact x = Exact::parse("sqrt(1 + 1e-40) - 1");
    for (const unsigned digits : {50U, 1000U, 1300U, 2500U, 6000U}) {
        CAPTURE(digits);
        const PrecisionScope scope(digits);
        const Real found = x.to<Real>();
        const PrecisionScope more(digits + 60);
        const Real exact = 1 / (pow(Real(10), 40) * (1 + sqrt(Real(1 + pow(Real(10), -40)))));
        CHECK(abs(found - exact) < exact * pow(Real(10), -static_cast<int>(digits)));
    }
}

TEST_CASE("a double halfway between two is decided by digits far behind") {
    const std::pair<const char*, double> rounded[] = {
        // 1 + 2^-53 lies halfway between 1 and the next double.
        {"1 + 2^-53 + 1e-60*sqrt(2)", 1.0 + 0x1p-52},
        {"1 + 2^-53 - 1e-60*sqrt(2)", 1.0},
        {"1 + 2^-53 + 1e-60", 1.0 + 0x1p-52}, // the same, rational
        {"1 + 2^-53 - 1e-60", 1.0},
        {"-1 - 2^-53 - 1e-60", -1.0 - 0x1p-52},
        {"2^-1074*(3/2 + 1e-60)", 0x1p-1073},
        {"2^-1074*(3/2 - 1e-60)", 0x1p-1074},
        {"1 + 2^-53", 1.0}, // ties to even
        {"1e-320", 1e-320},
    };
    for (const auto& row : rounded) {
        const auto& text = row.first;
        const auto value = row.second;
        CAPTURE(text);
        CHECK(Exact::parse(text).to<double>() == value);
    }
}

TEST_CASE("a value beyond the range of the arithmetic is an error") {
    for (const char* text : {"1e400", "1e-400", "pi*1e400", "pi*1e-400"}) {
        CHECK_THROWS_AS((void)Exact::parse(text).to<double>(), DomainError);
    }
}

TEST_CASE("signs are decided however close to zero") {
    const std::pair<const char*, int> signs[] = {
        {"0.1 + 0.2 - 0.3", 0},
        {"-1e-1000", -1},
        {"sqrt(2) - 1.41421356237309504880168872420969807856967187537694", 1},
        {"sqrt(2) - 1.41421356237309504880168872420969807856967187537695", -1},
        {"sqrt(1 + 1e-1000) - 1", 1},
        {"3 - Pi", -1},
        {"sqrt(Pi) - sqrt(Pi)", 0},
        // Large terms cancel: their first 60 digits, then 40 more.
        {"1e60*sqrt(2) - 1414213562373095048801688724209698078569671875376948073176679", 1},
        {"1e60*sqrt(2) - 1414213562373095048801688724209698078569671875376948073176680", -1},
        // The root of a number that appears negative at 30 digits.
        {"sqrt(sqrt(2) - 1.414213562373095048801688724209698078569)", 1},
    };
    for (const auto& row : signs) {
        const auto& text = row.first;
        const auto sign = row.second;
        CAPTURE(text);
        CHECK(Exact::parse(text).sign() == sign);
    }
    // The number is zero, but no number of digits can show it.
    CHECK_THROWS_AS((void)Exact::parse("sqrt(2)*sqrt(3) - sqrt(6)").sign(), BudgetError);
}

TEST_CASE("constants beyond 1e-100000 ... 1e100000 are refused at once") {
    for (const std::string text :
         {"10^10^10", "10^-(10^10)", "2^(2^64)", "1/2^(2^64)", "exp(1e9)", "-exp(1e9)", "exp(-1e9)",
          "exp(-1e7)", "gamma(1e9)", "1e100000*10", "exp(exp(exp(10)))"}) {
        CAPTURE(text);
        CHECK_THROWS_AS((void)formula::Exact::parse(text), formula::FormulaError);
    }
    for (const std::string text :
         {"1e100000", "1e-100000", "0", "exp(1e5)", "(1 + 1e-30)^(1e30)"}) {
        CAPTURE(text);
        CHECK_NOTHROW((void)formula::Exact::parse(text));
    }
}
