// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/conformance/answers/answers.hpp"
#include "edgeproof/conformance/questions/question.hpp"
#include "edgeproof/precision/error.hpp"
#include "tests/support/namespaces.hpp"
#include "tests/support/table.hpp"

#include <doctest/doctest.h>

#include <cmath>

namespace {

const std::string grid = R"(digits = 20
[scenes.hertz]
edges = ["left", "right"]
u = ["1/2", "1e-3"]
quantities = ["p", "P", "c_1"]
[scenes.hertz.profile]
kind = "power-law"
m = ["1", "2"]
C = "1"
[scenes.hertz.load]
a = ["1", "3/2"]
contact_modulus = "1"
)";

std::string refusal(const std::string& text) {
    try {
        (void)parse_recipe(text, "r.toml");
    } catch (const InputError& error) {
        return error.what();
    }
    return "accepted";
}

} // namespace

TEST_CASE("a range of a parameter is the grid of its values") {
    const auto ids = [](const std::string& range) {
        const Recipe recipe =
            parse_recipe(test::replaced(grid, "a = [\"1\", \"3/2\"]", "a = " + range), "r.toml");
        std::vector<std::string> list;
        for (const auto& question : recipe.questions.list) {
            if (question.id.starts_with("hertz:m=1:") && question.id.ends_with(":P")) {
                list.push_back(question.id);
            }
        }
        return list;
    };
    CHECK(ids("{ from = \"1\", to = \"3/2\", points = 3 }") ==
          std::vector<std::string>{"hertz:m=1:a=1:P", "hertz:m=1:a=1.25:P", "hertz:m=1:a=3/2:P"});
    CHECK(ids("{ from = \"1\", to = \"100\", per_decade = 1 }") ==
          std::vector<std::string>{"hertz:m=1:a=1:P", "hertz:m=1:a=10:P", "hertz:m=1:a=100:P"});
}

TEST_CASE("a grid becomes questions in a fixed order, with ids that describe them") {
    const Recipe recipe = parse_recipe(grid, "r.toml");
    CHECK(recipe.digits.count == 20);
    CHECK(recipe.questions.contacts.size() == 4);
    // Each contact has P; at the left edge c_1, p, p; at the right edge c_1, p, p.
    REQUIRE(recipe.questions.list.size() == 28);
    const char* const first[] = {"hertz:m=1:a=1:P",
                                 "hertz:m=1:a=1:left:c_1",
                                 "hertz:m=1:a=1:left:u=1/2:p",
                                 "hertz:m=1:a=1:left:u=1e-3:p",
                                 "hertz:m=1:a=1:right:c_1",
                                 "hertz:m=1:a=1:right:u=1/2:p",
                                 "hertz:m=1:a=1:right:u=1e-3:p",
                                 "hertz:m=1:a=3/2:P"};
    for (std::size_t i = 0; i < 8; ++i) {
        CHECK(recipe.questions.list[i].id == first[i]);
    }
    CHECK(recipe.questions.list.back().id == "hertz:m=2:a=3/2:right:u=1e-3:p");
    CHECK(recipe.questions.columns() ==
          std::vector<std::string>{"kind", "m", "C", "a", "contact_modulus"});
}

// P = pi a^2/4 for m = 1 (johnson1985): a = 2 under P = pi, and the place is rounded.
TEST_CASE("a place in a is a number where a is solved for") {
    const auto under = [](const std::string& P) {
        const std::string by_force =
            test::replaced(grid, "a = [\"1\", \"3/2\"]", "P = \"" + P + "\"");
        return parse_recipe(test::replaced(by_force, "\"1/2\"", "\"a/2\""), "r.toml").questions;
    };
    const Questions asked = under("pi");
    CHECK(asked.list[2].id == "hertz:m=1:left:u=a/2:p");
    CHECK(asked.list[2].u->rational() == 1);
    CHECK(under("1").list[2].u->text() == "0.564189583548"); // 1/sqrt(pi)
}

TEST_CASE("questions in binary64 are decimals that a double holds exactly") {
    const Questions asked = rounded_to_binary64(
        parse_recipe(test::replaced(grid, "\"1e-3\"", "\"0.1\""), "r.toml").questions);
    CHECK(asked.list[2].u->text() == "0.5");
    // 0.1 in binary64 is 3602879701896397/2^55.
    CHECK(asked.list[3].u->text() == "0.1000000000000000055511151231257827021181583404541015625");
    CHECK(asked.list[3].id == "hertz:m=1:a=1:left:u=0.1:p");
}

TEST_CASE("a recipe of more than a million questions is refused before its grids are expanded") {
    std::string big = test::replaced(grid, "u = [\"1/2\", \"1e-3\"]",
                                     "u = { from = \"1/1000000\", to = \"1/2\", points = 20000 }");
    std::string values;
    for (int i = 1; i <= 625; ++i) {
        values += (i == 1 ? "\"" : ", \"") + std::to_string(i) + "\"";
    }
    CHECK(refusal(test::replaced(big, "C = \"1\"", "C = [" + values + "]"))
              .find("more than a million questions; split the recipe") != std::string::npos);
}

namespace {

const std::string conditioning_header = "id,kind,m,C,a,contact_modulus,quantity,edge,u,value\n";

Agreements held(const std::string& rows, const Target& target = {}) {
    return compare(echoed_answers(parse_csv(conditioning_header + rows, "a.csv")), target, {});
}

double condition_number(const std::string& row) {
    const Agreements a = held(row);
    return a.cases.at(0).conditioning.value().number();
}

} // namespace

TEST_CASE("numbers beyond the range of a double have no neighbours, and nothing breaks") {
    for (const char* u : {"1e-400", "1e-330", "5e-324", "1e-300"}) {
        CAPTURE(u);
        const Agreements a = held(std::string("1,power-law,1,1,1,1,p,right,") + u + ",1\n");
        CHECK(a.cases.at(0).no_reference.empty());
        CHECK_FALSE(a.cases.at(0).pass);
    }
}

TEST_CASE("condition numbers by hand") {
    // P = E* C a^(m + 1) I(m), I'/I = (psi(3/2) - psi(2))/2 = 1/2 - log 2 at m = 1: a counts twice.
    CHECK(condition_number("1,power-law,1,1,1,1,P,,,1\n") ==
          doctest::Approx(2 + 1 + 1 + std::log(2.0) - 0.5).epsilon(1e-6));
    // The wedge, with m = 0 exact: p = acosh(a/x)/pi, x = a - u = 2^-30; the condition numbers for
    // u and a are u/x/acosh(a/x) each.
    const double x = 0x1p-30;
    const double each = 1 / (x * std::acosh(1 / x));
    // The ulp of u = 1 - 2^-30 is half of that of a = 1.
    CHECK(condition_number("2,power-law,0,1,1,1,p,right,0.999999999068677425384521484375,1\n") ==
          doctest::Approx(each * 1.5).epsilon(1e-4));
    // A zero value has no condition number.
    CHECK_FALSE(held("3,power-law,1,1,1,1,M,,,0\n").cases.at(0).conditioning);
}

TEST_CASE("without a target: 12 digits, or the digits that the conditioning leaves, are required") {
    const std::string wedge = "w,power-law,0,1,1,1,p,right,0.999999999068677425384521484375,";
    // The exact value is acosh(2^30)/pi = 6.8396025...; the rounding of the inputs explains a
    // relative error of 1e-10.
    const double exact = std::acosh(0x1p30) / std::acos(-1.0);
    const auto value = [&](double off) { return std::to_string(exact * (1 + off)); };
    const auto row = [&](double off) {
        char text[40];
        std::snprintf(text, sizeof text, "%.17g", exact * (1 + off));
        return wedge + text + "\n";
    };
    CHECK(value(0).substr(0, 5) == "6.839");
    CHECK(held(row(1e-8)).cases[0].pass);
    CHECK(held(row(1e-8)).cases[0].explained);
    CHECK_FALSE(held(row(1e-8)).cases[0].within);
    CHECK_FALSE(held(row(1e-6)).cases[0].pass);
    CHECK_FALSE(held(row(1e-8), {12.0, {}}).cases[0].pass);
    CHECK(held(row(1e-8), {12.0, {}, true}).cases[0].pass);
    // The value 0.3 (3-4-5 triangle) is well conditioned.
    const std::string hertz = "h,power-law,1,1,1,1,p,right,0.2,";
    CHECK(held(hertz + "0.3000000000001\n").cases[0].pass);
    CHECK_FALSE(held(hertz + "0.300000000001\n").cases[0].pass);
    CHECK_FALSE(held(hertz + "0.300000000001\n").cases[0].explained);
    CHECK_FALSE(held(hertz + "0.4\n").cases[0].pass);
}

TEST_CASE("a value that is zero is measured by the force and the length of its contact") {
    // M = 0 is compared with P (a + b) = 2 pi/4; if the contact is scaled by a million, so is the
    // tolerance.
    CHECK(held("m,power-law,1,1,1,1,M,,,1e-12\n").cases[0].pass);
    CHECK(held("m,power-law,1,1,1,1e6,M,,,1e-6\n").cases[0].pass);
    CHECK_FALSE(held("m,power-law,1,1,1,1e-6,M,,,1e-12\n").cases[0].pass);
}
