// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/conformance/answers/answers.hpp"
#include "edgeproof/conformance/causes/convention.hpp"
#include "edgeproof/io/foreign_text.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/rounding/text.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <utility>

namespace {

/// Answers to questions about contacts with the cells kind, m, ..., contact_modulus. A row:
/// quantity, edge, u, value.
Answers answered(const std::string& contact, const std::vector<std::string>& rows) {
    std::string text = "id,kind,m,C,phi,alpha,a,contact_modulus,quantity,edge,u,value\n";
    for (std::size_t i = 0; i < rows.size(); ++i) {
        text += std::to_string(i) + "," + contact + "," + rows[i] + "\n";
    }
    Answers answers = echoed_answers(parse_csv(text, "a.csv"));
    CHECK(answers.faults.empty());
    return answers;
}
// Hertz, a = 1: p = sqrt(u (2 - u))/2, so that p = 0.3 at u = 0.2 and 0.4 at u = 0.4 (3-4-5
// triangle).
const std::string hertz = "power-law,1,1,,,1,1";

Agreements held(const Answers& answers, const Target& target = {}) {
    return compare(answers, target, {});
}

} // namespace

TEST_CASE("digits and ulps by hand") {
    const Answers answers = answered(hertz, {"p,right,0.2,0.3", "p,left,0.2,0.3000003",
                                             "p,right,0.4,0.40000000000000005551115123125783",
                                             "p,right,0.4,0.2", "M,,,1e-12", "p,right,0.4,nan"});
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
    const std::string next = "0.50000000000000011102230246251565404236316680908203125";
    for (const auto& [contact, place] : {std::pair{"power-law,1,5/3,,,1,1", "p,right,0.2,"},
                                         {"power-law,1,5/4,,,1,1", "p,right,0.4,"},
                                         {"power-law,1,25/7,,,1,1", "p,left,0.04,"},
                                         {"power-law,1,5/7,,,1,7/3", "p,left,0.2,"}}) {
        CHECK(held(answered(contact, {place + next})).cases[0].ulps ==
              doctest::Approx(1).epsilon(1e-9));
    }
}

TEST_CASE("the reference is computed at what the row says, to the last bit") {
    // The binary64 u is a little larger than 0.2: p is larger by (1 - u)/sqrt(u (2 - u))/2 du.
    const Agreements a = held(
        answered(hertz, {"p,right,0.200000000000000011102230246251565404236316680908203125,0.3"}));
    // dp = 0.8/0.6/2 1.1102230246251565e-17 = 7.401486830834377e-18, relative to 0.3
    CHECK(a.cases[0].digits == doctest::Approx(-std::log10(7.401486830834377e-18 / 0.3)));
}

TEST_CASE("regimes") {
    const auto regimes = [](const std::string& contact, const std::vector<std::string>& places) {
        std::vector<Regime> found;
        for (const CaseAgreement& one : held(answered(contact, places)).cases) {
            found.push_back(one.regime);
        }
        return found;
    };
    // a + b = 1 + b, b < 1
    CHECK(regimes("tilted-wedge,,,0.2,0.1,1,1",
                  {"p,right,1e-4,1", "p,right,0.5,1", "p,right,0.999,1", "c_2,left,,1", "b,,,1"}) ==
          std::vector{Regime::near_edge, Regime::interior, Regime::apex, Regime::coefficient,
                      Regime::contact});
    CHECK(regimes(hertz, {"p,right,1.9999,1"}) == std::vector{Regime::near_edge});
}

TEST_CASE("a decimal comma is none if commas separate the cells; a column occurs once") {
    const Answers comma = answered(hertz, {"p,right,0.2,\"0,3\""});
    CHECK(comma.given.at(0).state == Answer::State::garbage);
    CHECK_THROWS_AS(
        (void)echoed_answers(parse_csv("id,quantity,kind,value,value\n1,P,x,1,2\n", "a")),
        InputError);
}

namespace {

/// Returns the conventions found for points of a tilted wedge at both edges, answered by
/// f(reference, reference at the other edge).
template <class F> std::vector<Convention> conventions_of(const F& f) {
    const std::string wedge = "tilted-wedge,,,0.2,0.05,1,1";
    std::vector<std::string> rows;
    for (const std::string edge : {"right", "left"}) {
        for (const char* const u : {"0.001", "0.01", "0.1", "0.2"}) {
            rows.push_back("p," + edge + "," + u + ",");
        }
    }
    std::vector<double> exact;
    for (const std::string& row : rows) {
        const Agreements one = held(answered(wedge, {row + "0"}));
        exact.push_back(one.references[0].value.value.midpoint().convert_to<double>());
    }
    for (std::size_t i = 0; i < 8; ++i) {
        rows[i] +=
            fmt::format("{:.17g}", f(i < 4 ? "right" : "left", exact[i], exact[(i + 4) % 8]));
    }
    const Answers answers = answered(wedge, rows);
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
    for (const auto& row : cases) {
        CHECK(only(conventions_of([&](S, double p, double other) {
                  return row.first(p, other);
              })) == "p: " + row.second + " in 8");
    }
    CHECK(only(conventions_of([](S edge, double p, double) { return edge == "left" ? -p : p; })) ==
          "p, left edge: minus ours in 4");
    // Wrong values follow no convention.
    CHECK(conventions_of([](S, double p, double) { return p + 0.01; }).empty());
}

TEST_CASE("of many failing rows the first are searched for causes") {
    std::vector<std::string> rows(most_failing, "p,right,0.2,0.6");
    rows.resize(most_failing + 100, "p,right,0.2,5");
    const Answers answers = answered(hertz, rows);
    const auto found = infer_conventions(answers, held(answers), {});
    REQUIRE(found.size() == 1);
    CHECK(found[0].name == "factor-2");
    CHECK(found[0].rows == most_failing);
}
