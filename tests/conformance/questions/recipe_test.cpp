// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/conformance/questions/recipe.hpp"
#include "edgeproof/precision/error.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

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

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
}

} // namespace

TEST_CASE("a range of a parameter is the grid of its values") {
    const auto ids = [](const std::string& range) {
        const Recipe recipe =
            parse_recipe(replaced(grid, "a = [\"1\", \"3/2\"]", "a = " + range), "r.toml");
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

TEST_CASE("questions in binary64 are decimals that a double holds exactly") {
    const Questions asked = rounded_to_binary64(
        parse_recipe(replaced(grid, "\"1e-3\"", "\"0.1\""), "r.toml").questions);
    CHECK(asked.list[2].u->text() == "0.5");
    // 0.1 in binary64 is 3602879701896397/2^55.
    CHECK(asked.list[3].u->text() == "0.1000000000000000055511151231257827021181583404541015625");
    CHECK(asked.list[3].id == "hertz:m=1:a=1:left:u=0.1:p");
}

TEST_CASE("a recipe of more than a million questions is refused before its grids are expanded") {
    std::string big = replaced(grid, "u = [\"1/2\", \"1e-3\"]",
                               "u = { from = \"1/1000000\", to = \"1/2\", points = 20000 }");
    std::string values;
    for (int i = 1; i <= 625; ++i) {
        values += (i == 1 ? "\"" : ", \"") + std::to_string(i) + "\"";
    }
    CHECK(refusal(replaced(big, "C = \"1\"", "C = [" + values + "]"))
              .find("more than a million questions; split the recipe") != std::string::npos);
}
