// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/conformance/answers/agreement.hpp"
#include "edgeproof/conformance/answers/number_text.hpp"
#include "edgeproof/conformance/causes/convention.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/rounding/text.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdio>
#include <functional>
#include <utility>

namespace {

const std::string agreement_header =
    "id,kind,m,C,phi,alpha,a,contact_modulus,quantity,edge,u,value\n";
// Hertz, a = 1: p = sqrt(u (2 - u))/2, so that p = 0.3 at u = 0.2 and 0.4 at u = 0.4 (3-4-5
// triangle).
const std::string hertz_cells = ",power-law,1,1,,,1,1,";

Answers answered(const std::string& rows) {
    return echoed_answers(parse_csv(agreement_header + rows, "a.csv"));
}

Agreements held(const Answers& answers, const Target& target = {}) {
    return compare(answers, target, {});
}

} // namespace

TEST_CASE("digits and ulps by hand") {
    const Answers answers = answered("exact" + hertz_cells +
                                     "p,right,0.2,0.3\n"
                                     "millionth" +
                                     hertz_cells +
                                     "p,left,0.2,0.3000003\n"
                                     "ulp" +
                                     hertz_cells +
                                     "p,right,0.4,0.40000000000000005551115123125783\n"
                                     "half" +
                                     hertz_cells +
                                     "p,right,0.4,0.2\n"
                                     "zero" +
                                     hertz_cells +
                                     "M,,,1e-12\n"
                                     "nan" +
                                     hertz_cells + "p,right,0.4,nan\n");
    REQUIRE(answers.faults.empty());
    const Agreements a = held(answers, {6.0, {}});
    REQUIRE(a.cases.size() == 6);
    CHECK(a.cases[0].digits == a.digits);
    CHECK(a.cases[0].ulps == 0);
    CHECK(a.cases[1].digits == doctest::Approx(6).epsilon(1e-9));
    CHECK(a.cases[1].pass);                                      // 1e-6 is within 10^-6
    CHECK(a.cases[2].ulps == doctest::Approx(1).epsilon(1e-12)); // 2^-54
    CHECK(a.cases[3].digits == doctest::Approx(std::log10(2.0)));
    CHECK_FALSE(a.cases[3].pass);
    // P = pi/4 and a + b = 2: 1e-12 of pi/2
    CHECK(a.cases[4].digits == doctest::Approx(12 + std::log10(std::acos(-1.0) / 2)));
    CHECK(a.cases[4].pass);
    CHECK_FALSE(a.cases[5].pass);
    CHECK(held(answers, {{}, 0.99}).cases[2].pass == false);
    CHECK(held(answers, {{}, 1.01}).cases[2].pass);
    CHECK_FALSE(held(answers, {6.001, {}}).cases[1].pass);
}

TEST_CASE("the unit in the last place of a power of two, whose ball reaches below it") {
    // p = C sqrt(u (2 - u))/2: 0.6 C/2 at u = 0.2, 0.8 C/2 at 0.4 and 0.28 C/2 at 0.04. The double
    // after 1/2 is 1/2 + 2^-53, one unit off.
    const std::string next = "0.50000000000000011102230246251565404236316680908203125\n";
    const Answers answers = answered("1,power-law,1,5/3,,,1,1,p,right,0.2," + next +
                                     "2,power-law,1,5/4,,,1,1,p,right,0.4," + next +
                                     "3,power-law,1,25/7,,,1,1,p,left,0.04," + next +
                                     "4,power-law,1,5/7,,,1,7/3,p,left,0.2," + next);
    REQUIRE(answers.faults.empty());
    for (const CaseAgreement& held_case : held(answers).cases) {
        CHECK(held_case.ulps == doctest::Approx(1).epsilon(1e-9));
    }
}

TEST_CASE("the reference is computed at what the row says, to the last bit") {
    // The binary64 u is a little larger than 0.2: p is larger by (1 - u)/sqrt(u (2 - u))/2 du.
    const Answers answers =
        answered("u" + hertz_cells +
                 "p,right,0.200000000000000011102230246251565404236316680908203125," + "0.3\n");
    const Agreements a = held(answers);
    // dp = 0.8/0.6/2 1.1102230246251565e-17 = 7.401486830834377e-18, relative to 0.3
    CHECK(a.cases[0].digits == doctest::Approx(-std::log10(7.401486830834377e-18 / 0.3)));
}

TEST_CASE("regimes") {
    const std::string wedge = ",tilted-wedge,,,0.2,0.1,1,1,";
    const Agreements a = held(answered("1" + wedge +
                                       "p,right,1e-4,1\n" // L = 1 + b, b < 1
                                       "2" +
                                       wedge +
                                       "p,right,0.5,1\n"
                                       "3" +
                                       wedge +
                                       "p,right,0.999,1\n"
                                       "4" +
                                       wedge +
                                       "c_2,left,,1\n"
                                       "5" +
                                       wedge +
                                       "b,,,1\n"
                                       "6,power-law,1,1,,,1,1,p,right,1.9999,1\n"));
    const Regime expected[] = {Regime::near_edge,   Regime::interior, Regime::apex,
                               Regime::coefficient, Regime::contact,  Regime::near_edge};
    for (std::size_t i = 0; i < 6; ++i) {
        CHECK(a.cases[i].regime == expected[i]);
    }
}

TEST_CASE("a decimal comma is none if commas separate the cells; a column occurs once") {
    const Answers comma = answered("1" + hertz_cells + "p,right,0.2,\"0,3\"\n");
    CHECK(comma.given.at(0).state == Answer::State::garbage);
    CHECK_THROWS_AS(
        (void)echoed_answers(parse_csv("id,quantity,kind,value,value\n1,P,x,1,2\n", "a")),
        InputError);
}

namespace {

/// Returns the conventions found for points of a tilted wedge at both edges, answered by
/// f(reference, reference at the other edge).
template <class F> std::vector<Convention> conventions_of(const F& f) {
    const std::string wedge = ",tilted-wedge,,,0.2,0.05,1,1,p,";
    const char* const points[] = {"0.001", "0.01", "0.1", "0.2"};
    std::string rows;
    for (const char* edge : {"right", "left"}) {
        for (const char* u : points) {
            rows += std::string(edge) + u + wedge + edge + "," + u + ",0\n";
        }
    }
    const Agreements exact = held(answered(rows));
    const auto value = [&](std::size_t i) {
        return exact.references[i].value.value.midpoint().convert_to<double>();
    };
    rows.clear();
    for (std::size_t i = 0; i < 8; ++i) {
        const std::string edge = i < 4 ? "right" : "left";
        char text[40];
        std::snprintf(text, sizeof text, "%.17g", f(edge, value(i), value((i + 4) % 8)));
        rows += edge + std::to_string(i) + wedge + edge + "," + points[i % 4] + "," + text + "\n";
    }
    const Answers answers = answered(rows);
    return infer_conventions(answers, held(answers), {});
}

} // namespace

TEST_CASE("another convention is recognised and reported, with its accuracy") {
    const double pi = std::acos(-1.0);
    const auto only = [](const std::vector<Convention>& found) {
        REQUIRE(found.size() == 1);
        CHECK(found[0].digits > 14);
        return found[0].of + ": " + found[0].relation + " in " + std::to_string(found[0].rows);
    };
    using S = const std::string&;
    CHECK(conventions_of([](S, double p, double) { return p; }).empty());
    const std::vector<std::pair<std::function<double(double, double)>, std::string>> cases{
        {[](double p, double) { return 2 * p; }, "2 times ours"},
        {[](double p, double) { return p / 2; }, "1/2 times ours"},
        {[&](double p, double) { return p * pi; }, "pi times ours"},
        {[&](double p, double) { return -p * pi / 180; }, "-pi/180 times ours"},
        {[](double p, double) { return -p; }, "minus ours"},
        {[](double p, double) { return 1.37 * p; }, "1.37 times ours"},
        {[](double, double other) { return other; }, "ours at the other edge"},
        {[](double, double other) { return 2 * other; }, "2 times ours at the other edge"}};
    for (const auto& [answer, relation] : cases) {
        CHECK(only(conventions_of([&](S, double p, double other) { return answer(p, other); })) ==
              "p: " + relation + " in 8");
    }
    CHECK(only(conventions_of([](S edge, double p, double) { return edge == "left" ? -p : p; })) ==
          "p, left edge: minus ours in 4");
    // Wrong values follow no convention.
    CHECK(conventions_of([](S, double p, double) { return p + 0.01; }).empty());
}

TEST_CASE("of many failing rows the first are searched for causes") {
    std::string rows;
    for (std::size_t k = 0; k < most_failing + 100; ++k) {
        rows +=
            std::to_string(k) + hertz_cells + "p,right,0.2," + (k < most_failing ? "0.6\n" : "5\n");
    }
    const Answers answers = answered(rows);
    const auto found = infer_conventions(answers, held(answers), {});
    REQUIRE(found.size() == 1);
    CHECK(found[0].name == "factor-2");
    CHECK(found[0].rows == most_failing);
}
