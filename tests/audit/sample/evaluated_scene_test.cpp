// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/ledger/claim.hpp"
#include "edgeproof/audit/ledger/ledger_parts.hpp"
#include "edgeproof/audit/sample/evaluated_scene.hpp"
#include "edgeproof/precision/error.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

namespace {

constexpr unsigned setting_digits = 40;

SceneSpec scene(const std::string& profile, const std::map<std::string, std::string>& parameters) {
    SceneSpec spec;
    spec.family = "test";
    spec.profile = profile;
    for (const auto& [name, text] : parameters) {
        spec.parameters.emplace(name, Exact::parse(text));
    }
    return spec;
}

SceneSpec hertz_scene() {
    return scene("power-law", {{"m", "1"}, {"C", "3/1000"}, {"a", "7/3"}, {"Es", "110"}});
}
SceneSpec tilted_scene() {
    return scene("tilted-flat-and-rounded",
                 {{"alpha", "1/10"}, {"t", "1/2"}, {"R", "3"}, {"a", "11/5"}, {"Es", "70"}});
}

Expr setting_formula(const std::string& text) {
    Vocabulary v;
    for (const std::string& name : scene_symbols()) {
        v.symbols.add(name);
    }
    for (const char* name : {"C", "m", "t", "R", "alpha", "phi", "y"}) {
        v.symbols.add(name);
    }
    for (const auto& [name, arity] : scene_functions()) {
        v.symbols.add_function(name, arity);
    }
    return parse_formula(text, v);
}

/// Returns the digits to which two formulas agree in an evaluated scene.
double agreement(const EvaluatedScene& scene_values, const std::string& x, const std::string& y,
                 const Place* place = nullptr) {
    const FormulaValue fx = scene_values.evaluate(setting_formula(x), place);
    const FormulaValue fy = scene_values.evaluate(setting_formula(y), place);
    CHECK(fx.converged);
    CHECK(fy.converged);
    const Real difference = abs(fx.value - fy.value);
    return difference == 0 ? 1000.0
                           : (-log10(Real(difference / abs(fy.value)))).convert_to<double>();
}

} // namespace

TEST_CASE("naive integrals lose nothing at their end points") {
    const EvaluatedScene scene_values(hertz_scene(), setting_digits);
    // These closed forms are in tables of integrals.
    CHECK(agreement(scene_values, "integral(1/sqrt(a^2-s^2), s, -a, a)", "Pi") > setting_digits);
    CHECK(agreement(scene_values, "integral(1/sqrt((a-s)*(s+b)), s, -b, a)", "Pi") >
          setting_digits);
    CHECK(agreement(scene_values, "integral(s^2/sqrt(a^2-s^2), s, -a, a)", "Pi*a^2/2") >
          setting_digits);
    CHECK(agreement(scene_values, "integral(log(s), s, 0, a)", "a*log(a)-a") > setting_digits);
    CHECK(agreement(scene_values, "integral(abs(s-1/3), s, 0, 1)", "5/18") > setting_digits);
    CHECK(agreement(scene_values, "integral(1/sqrt(s), s, a, 0)", "-2*sqrt(a)") > setting_digits);
    CHECK(agreement(scene_values, "pv(1/(s-1), s, 0, a, 1)", "log(a-1)") > setting_digits);
    CHECK(agreement(scene_values, "pv(s^2/sqrt(a^2-s^2)/(s-1/7), s, -a, a, 1/7)", "Pi/7") >
          setting_digits);
}

TEST_CASE("the Hertzian contact by every printed form, to within 1e-25 of the edge") {
    const EvaluatedScene scene_values(hertz_scene(), setting_digits);
    const std::string closed = "Es*C/2*sqrt((a-x)*(a+x))"; // Hertz
    for (const char* fraction : {"1e-25", "1/1000", "1/3"}) {
        CAPTURE(fraction);
        const Place place = scene_values.place(Edge::right, Exact::parse(fraction));
        CHECK(agreement(scene_values, "p(x)", closed, &place) > setting_digits);
        CHECK(agreement(scene_values,
                        "Es/(2*Pi)*sqrt(a^2-x^2)*pv(g1(s)/sqrt(a^2-s^2)/(s-x), s, -a, a, x)",
                        closed, &place) > setting_digits);
        CHECK(agreement(scene_values, "1/Pi*integral(P1of(s)/sqrt(s^2-x^2), s, x, a)", closed,
                        &place) > setting_digits);
    }
    CHECK(agreement(scene_values, "P", "Pi*Es*C*a^2/4") > setting_digits);
    CHECK(agreement(scene_values, "P1", "Pi*Es*C*a/2") > setting_digits);
    CHECK(agreement(scene_values, "right.c0", "Es*C/2*sqrt(2*a)") > setting_digits);
}

TEST_CASE("along the family of contacts that are not symmetric") {
    const EvaluatedScene scene_values(tilted_scene(), setting_digits);
    CHECK(agreement(scene_values, "bof(a)", "b") > setting_digits);
    CHECK(agreement(scene_values, "binv(b)", "a") > setting_digits);
    CHECK(agreement(scene_values, "binv(bof(a/2))", "a/2") > setting_digits);
    CHECK(agreement(scene_values, "Pof(a)", "P") > setting_digits);
    CHECK(agreement(scene_values, "P1of(a)", "P1") > setting_digits);
    const Real balance =
        scene_values.evaluate(setting_formula("integral(g1(s)/sqrt((a-s)*(s+b)), s, -b, a)")).value;
    CHECK(abs(balance) < pow(Real(10), -static_cast<int>(setting_digits)));
    const Place left = scene_values.place(Edge::left, Exact::parse("1/20"));
    CHECK(agreement(scene_values, "1/Pi*integral(P1of(s)/sqrt((s-x)*(x+bof(s))), s, binv(-x), a)",
                    "p(x)", &left) > setting_digits);
}

TEST_CASE("a name that a scene does not have is an error that states the name") {
    const EvaluatedScene scene_values(hertz_scene(), setting_digits);
    CHECK_THROWS_WITH_AS(static_cast<void>(scene_values.evaluate(setting_formula("t/a"))),
                         "'t' has no value in a scene of family test", Error);
    CHECK_THROWS_AS(static_cast<void>(scene_values.evaluate(setting_formula("x"))), Error);
    CHECK_THROWS_AS(static_cast<void>(scene_values.evaluate(setting_formula("1/(a-7/3)"))),
                    DomainError);
}

TEST_CASE("conditions") {
    const EvaluatedScene scene_values(hertz_scene(), setting_digits);
    Vocabulary v;
    for (const char* name : {"a", "C", "x"}) {
        v.symbols.add(name);
    }
    CHECK(scene_values.holds(parse_condition("2 < a < 3 and C > 0", v)));
    CHECK_FALSE(scene_values.holds(parse_condition("2 < a < 2.3", v)));
    CHECK(scene_values.holds(parse_condition("a = 7/3", v)));
}
