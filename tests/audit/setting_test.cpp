// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/claim.hpp"
#include "edgeproof/audit/setting.hpp"
#include "edgeproof/precision/error.hpp"

#include <doctest/doctest.h>

using namespace edgeproof;

namespace {

constexpr unsigned digits = 40;

SceneSpec scene(const std::string& profile, const std::map<std::string, std::string>& parameters) {
    SceneSpec spec;
    spec.family = "test";
    spec.profile = profile;
    for (const auto& [name, text] : parameters) {
        spec.parameters.emplace(name, Exact::parse(text));
    }
    return spec;
}

SceneSpec hertz() {
    return scene("power-law", {{"m", "1"}, {"C", "3/1000"}, {"a", "7/3"}, {"Es", "110"}});
}
SceneSpec tilted() {
    return scene("tilted-flat-and-rounded",
                 {{"alpha", "1/10"}, {"t", "1/2"}, {"R", "3"}, {"a", "11/5"}, {"Es", "70"}});
}

Expr formula(const std::string& text) {
    Vocabulary v;
    for (const std::string& name : setting_symbols()) {
        v.symbols.add(name);
    }
    for (const char* name : {"C", "m", "t", "R", "alpha", "phi", "y"}) {
        v.symbols.add(name);
    }
    for (const auto& [name, arity] : setting_functions()) {
        v.symbols.add_function(name, arity);
    }
    return parse_formula(text, v);
}

/// Digits to which two formulas agree in a setting.
double agreement(const Setting& setting, const std::string& x, const std::string& y,
                 const Place* place = nullptr) {
    const FormulaValue fx = setting.evaluate(formula(x), place);
    const FormulaValue fy = setting.evaluate(formula(y), place);
    CHECK(fx.converged);
    CHECK(fy.converged);
    const Real difference = abs(fx.value - fy.value);
    return difference == 0 ? 1000.0
                           : (-log10(Real(difference / abs(fy.value)))).convert_to<double>();
}

} // namespace

TEST_CASE("naive integrals lose nothing at their end points") {
    const Setting setting(hertz(), digits);
    // Closed forms from any table of integrals.
    CHECK(agreement(setting, "integral(1/sqrt(a^2-s^2), s, -a, a)", "Pi") > digits);
    CHECK(agreement(setting, "integral(1/sqrt((a-s)*(s+b)), s, -b, a)", "Pi") > digits);
    CHECK(agreement(setting, "integral(s^2/sqrt(a^2-s^2), s, -a, a)", "Pi*a^2/2") > digits);
    CHECK(agreement(setting, "integral(log(s), s, 0, a)", "a*log(a)-a") > digits);
    CHECK(agreement(setting, "integral(abs(s-1/3), s, 0, 1)", "5/18") > digits);
    CHECK(agreement(setting, "integral(1/sqrt(s), s, a, 0)", "-2*sqrt(a)") > digits);
    CHECK(agreement(setting, "pv(1/(s-1), s, 0, a, 1)", "log(a-1)") > digits);
    CHECK(agreement(setting, "pv(s^2/sqrt(a^2-s^2)/(s-1/7), s, -a, a, 1/7)", "Pi/7") > digits);
}

TEST_CASE("the Hertzian contact by every printed form, to within 1e-25 of the edge") {
    const Setting setting(hertz(), digits);
    const std::string closed = "Es*C/2*sqrt((a-x)*(a+x))"; // Hertz
    for (const char* fraction : {"1e-25", "1/1000", "1/3"}) {
        CAPTURE(fraction);
        const Place place = setting.place(Edge::right, Exact::parse(fraction));
        CHECK(agreement(setting, "p(x)", closed, &place) > digits);
        CHECK(agreement(setting,
                        "Es/(2*Pi)*sqrt(a^2-x^2)*pv(g1(s)/sqrt(a^2-s^2)/(s-x), s, -a, a, x)",
                        closed, &place) > digits);
        CHECK(agreement(setting, "1/Pi*integral(P1of(s)/sqrt(s^2-x^2), s, x, a)", closed, &place) >
              digits);
    }
    CHECK(agreement(setting, "P", "Pi*Es*C*a^2/4") > digits);
    CHECK(agreement(setting, "P1", "Pi*Es*C*a/2") > digits);
    CHECK(agreement(setting, "right.c0", "Es*C/2*sqrt(2*a)") > digits);
}

TEST_CASE("along the family of contacts that are not symmetric") {
    const Setting setting(tilted(), digits);
    CHECK(agreement(setting, "bof(a)", "b") > digits);
    CHECK(agreement(setting, "binv(b)", "a") > digits);
    CHECK(agreement(setting, "binv(bof(a/2))", "a/2") > digits);
    CHECK(agreement(setting, "Pof(a)", "P") > digits);
    CHECK(agreement(setting, "P1of(a)", "P1") > digits);
    const Real balance =
        setting.evaluate(formula("integral(g1(s)/sqrt((a-s)*(s+b)), s, -b, a)")).value;
    CHECK(abs(balance) < pow(Real(10), -static_cast<int>(digits)));
    const Place left = setting.place(Edge::left, Exact::parse("1/20"));
    CHECK(agreement(setting, "1/Pi*integral(P1of(s)/sqrt((s-x)*(x+bof(s))), s, binv(-x), a)",
                    "p(x)", &left) > digits);
}

TEST_CASE("what a scene does not have is an error that names it") {
    const Setting setting(hertz(), digits);
    CHECK_THROWS_WITH_AS(static_cast<void>(setting.evaluate(formula("t/a"))),
                         "'t' has no value in a scene of family test", Error);
    CHECK_THROWS_AS(static_cast<void>(setting.evaluate(formula("x"))), Error);
    CHECK_THROWS_AS(static_cast<void>(setting.evaluate(formula("1/(a-7/3)"))), DomainError);
}

TEST_CASE("conditions") {
    const Setting setting(hertz(), digits);
    Vocabulary v;
    for (const char* name : {"a", "C", "x"}) {
        v.symbols.add(name);
    }
    CHECK(setting.holds(parse_condition("2 < a < 3 and C > 0", v)));
    CHECK_FALSE(setting.holds(parse_condition("2 < a < 2.3", v)));
    CHECK(setting.holds(parse_condition("a = 7/3", v)));
}
