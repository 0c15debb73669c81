// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/conformance/causes/convention.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <random>

// Programs in binary64 and binary32 that subtract nearly equal lengths. Their closed forms are
// those of Hertz, p = E* C sqrt(a^2 - x^2)/2, and of the wedge, p = E* C acosh(a/x)/pi.

namespace {

const std::string lossy_head = "id,kind,m,C,t,R,a,contact_modulus,quantity,edge,u,value\n";

struct LossyContact {
    int m;
    double a;
};

/// The causes found for p at 20 distances from both edges, with E* = C = 1.
std::vector<Convention>
causes_of_pressures(const std::function<double(const LossyContact&, double u)>& p) {
    std::string text = lossy_head;
    int id = 0;
    for (const LossyContact& contact : {LossyContact{1, 1.3}, LossyContact{0, 3}}) {
        for (const char* edge : {"right", "left"}) {
            for (int k = 0; k < 20; ++k) {
                const double u = 0.7 * std::pow(10, -0.8 * k);
                text += fmt::format("{},power-law,{},1,,,{:.17g},1,p,{},{:.17g},{:.17g}\n", ++id,
                                    contact.m, contact.a, edge, u, p(contact, u));
            }
        }
    }
    const Answers answers = echoed_answers(parse_csv(text, "a.csv"));
    return infer_conventions(answers, compare(answers, {}, {}), {});
}

double from_x(const LossyContact& contact, double x) {
    const double a = contact.a;
    return contact.m == 1 ? std::sqrt(std::max(a * a - x * x, 0.0)) / 2
                          : std::acosh(std::max(a / x, 1.0)) / std::acos(-1.0);
}
/// The same from u: a/x = 1 + u/(a - u), and acosh(1 + z) = log1p(z + sqrt(z (2 + z))).
double from_u(const LossyContact& contact, double u) {
    const double a = contact.a;
    const double z = u / (a - u);
    return contact.m == 1 ? std::sqrt(u * (2 * a - u)) / 2
                          : std::log1p(z + std::sqrt(z * (2 + z))) / std::acos(-1.0);
}

} // namespace

TEST_CASE(
    "a loss of digits that follows u is named cancellation, with its rate and its beginning") {
    CHECK(causes_of_pressures(from_u).empty());
    const auto of_double = causes_of_pressures(
        [](const LossyContact& contact, double u) { return from_x(contact, contact.a - u); });
    REQUIRE(of_double.size() == 1);
    const Convention& c = of_double[0];
    CHECK(c.name == "cancellation");
    CHECK(c.of == "p");
    CHECK(c.factor == 1);
    CHECK(c.rows == c.failing);
    CHECK(c.rows > 30);
    CAPTURE(c.relation);
    double rate = 0;
    double begins = 0;
    double none = 0;
    REQUIRE(std::sscanf(c.relation.c_str(),
                        "right, but lose %lf digits for each decade by which u decreases: the loss "
                        "begins at %lf (a + b), and no digit is left at %lf (a + b)",
                        &rate, &begins, &none) == 3);
    // An ulp of x/2 in u changes p by a relative 2^-54 a/u: one digit for each decade.
    CHECK(rate == doctest::Approx(1).epsilon(0.1));
    CHECK(begins > 1e-3);
    CHECK(none > 1e-18);
    CHECK(none < 1e-15);
    CHECK(c.relation.find("binary64") != std::string::npos);
    CHECK(c.hint.find("compute from u") != std::string::npos);
}

TEST_CASE("cancellation in binary32 has the level of binary32") {
    const auto found = causes_of_pressures([](const LossyContact& contact, double u) {
        const float x = static_cast<float>(contact.a) - static_cast<float>(u);
        return from_x({contact.m, static_cast<double>(static_cast<float>(contact.a))},
                      static_cast<double>(x));
    });
    REQUIRE(found.size() == 1);
    CHECK(found[0].name == "cancellation");
    CHECK(found[0].relation.find("binary32") != std::string::npos);
}

TEST_CASE("errors that grow towards the edge for another reason are not called cancellation") {
    const auto none = [](const std::function<double(const LossyContact&, double)>& p) {
        const auto found = causes_of_pressures(p);
        return std::ranges::none_of(found, [](const auto& c) { return c.name == "cancellation"; });
    };
    // The edge is displaced by 1e-8, by 1e-15 and by 1e-3: one sign, at the levels of both formats
    // and at another one.
    for (const double shift : {1e-8, 1e-15, 1e-3}) {
        CAPTURE(shift);
        CHECK(none([&](const auto& contact, double u) { return from_u(contact, u + shift); }));
    }
    // An error of a constant size: half a digit for each decade.
    CHECK(none([](const auto& contact, double u) { return from_u(contact, u) + 1e-14; }));
    // An error that does not depend on u.
    CHECK(none([](const auto& contact, double u) {
        return from_u(contact, u) * (1 + 1e-9 * std::sin(1e4 * std::log(u)));
    }));
}

// P = E*/(2 R) (a^2 acos(t/a) - t sqrt(a^2 - t^2)) of the flat with rounded edges, from
// P = E* int_t^a g'(x) x/sqrt(a^2 - x^2) dx with g' = (x - t)/R: a difference of terms of the order
// d^(1/2) that leaves d^(3/2), d = a - t.
TEST_CASE("a loss of digits that follows the distance of the edge from a knot is named") {
    std::string text = lossy_head;
    for (int k = 0; k < 14; ++k) {
        const double a = 1 + std::pow(10, -0.5 * k - 0.2);
        text += fmt::format("{},flat-and-rounded,,,1,1,{:.17g},1,P,,,{:.17g}\n", k, a,
                            (a * a * std::acos(1 / a) - std::sqrt(a * a - 1)) / 2);
    }
    const Answers answers = echoed_answers(parse_csv(text, "a.csv"));
    const auto found = infer_conventions(answers, compare(answers, {}, {}), {});
    REQUIRE(found.size() == 1);
    CHECK(found[0].name == "cancellation");
    CHECK(found[0].of == "P");
    CHECK(found[0].relation.find("the distance between the edge and the nearest knot") !=
          std::string::npos);
}

// named_causes_test.cpp has the mistakes that must be named under noise; here nothing must be
// named.

namespace {

const std::string noisy_head =
    "id,kind,m,C,phi,alpha,t,R,a,P,E1,nu1,E2,nu2,quantity,edge,u,value\n";

/// The answers of a program to the rows: f(exact value) for each.
Answers answered(const std::vector<std::string>& rows, const std::function<double(double)>& f) {
    const auto with = [&](const std::function<double(std::size_t)>& value) {
        std::string text = noisy_head;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            text += fmt::format("{},{},{:.17g}\n", i, rows[i], value(i));
        }
        return echoed_answers(parse_csv(text, "a"));
    };
    const auto exact = compare(with([](std::size_t) { return 1; }), {}, {}).references;
    return with(
        [&](std::size_t i) { return f(exact[i].value.value.midpoint().convert_to<double>()); });
}

/// The load, three coefficients and eight pressures at each edge of contacts with a closed form.
std::vector<std::string> rows_of_every_kind() {
    std::vector<std::string> rows;
    for (const std::string contact :
         {"power-law,1,1/50,,,,,2", "power-law,0,0.1,,,,,0.7", "flat-and-rounded,,,,,0.5,20,1.5",
          "tilted-wedge,,,0.2,0.05,,,1.3", "tilted-flat-and-rounded,,,,0.01,1,9,3"}) {
        const std::string bodies = contact + ",,115,0.32,70,0.25,";
        rows.push_back(bodies + "P,,");
        for (const std::string edge : {"right", "left"}) {
            for (const std::string c : {"c_0", "c_1", "c_2"}) {
                rows.push_back(bodies + c + "," + edge + ",");
            }
            for (const std::string u :
                 {"1e-6", "1e-3", "0.01", "0.03", "0.1", "0.17", "0.31", "0.6"}) {
                rows.push_back(bodies + "p," + edge + "," + u);
            }
        }
    }
    return rows;
}

} // namespace

TEST_CASE("noise alone has no cause, and errors without a cause are reported as such") {
    std::mt19937_64 random(2);
    std::normal_distribution<double> normal;
    for (const double noise : {1e-6, 1e-4, 1e-2, 0.1, 1.0}) {
        CAPTURE(noise);
        const Answers answers = answered(rows_of_every_kind(), [&](double exact) {
            return exact * (1 + noise * normal(random));
        });
        const Agreements agreements = compare(answers, Target{7, {}, false}, {});
        const auto found = infer_conventions(answers, agreements, {});
        CHECK(found.empty());
        CHECK(unexplained(answers, agreements, found) == std::vector<std::string>{"P", "c_k", "p"});
    }
}

// With half of P, p at these places of a nearly flat contact is 0.79 times p, to 2 %.
TEST_CASE("a constant is not called a mistake that nearly has its effect") {
    std::vector<std::string> rows;
    for (const std::string P : {"20", "30"}) {
        for (const std::string edge : {"right", "left"}) {
            for (const std::string u : {"0.01", "0.013", "0.016", "0.02", "0.023", "0.027", "0.03",
                                        "0.034", "0.037", "0.04", "0.046", "0.055"}) {
                rows.push_back("flat-and-rounded,,,,,1,50,," + P + ",9000,0.3,9000,0.3,p," + edge +
                               "," + u);
            }
        }
    }
    std::mt19937_64 random(3);
    std::normal_distribution<double> normal;
    for (const double noise : {0.0, 1e-4, 1e-3}) {
        CAPTURE(noise);
        const Answers answers = answered(
            rows, [&](double exact) { return exact * 0.795 * (1 + noise * normal(random)); });
        const auto found =
            infer_conventions(answers, compare(answers, Target{5, {}, false}, {}), {});
        REQUIRE(found.size() == 1);
        CAPTURE(found[0].relation);
        CHECK(found[0].name == "factor");
        CHECK(found[0].factor == doctest::Approx(0.795).epsilon(1e-3));
        CHECK(found[0].also.empty());
    }
}
