// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/formula/expr.hpp"

#include "edgeproof/formula/parse.hpp"
#include "edgeproof/precision/error.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <string>

namespace {

formula::Expr named(const std::string& text) {
    formula::Symbols symbols{"a", "b", "c", "d"};
    for (int k = 0; k <= 60; ++k) {
        symbols.add("y" + std::to_string(k));
    }
    return formula::parse(text, symbols);
}

} // namespace

TEST_CASE("definitions are put into each other, in any order") {
    const auto found = formula::put_into_each_other(
        {{"a", named("b + c")}, {"b", named("2*c")}, {"c", named("d^2")}});
    CHECK(to_text(found.at("a")) == "2*d^2 + d^2");
    CHECK(to_text(found.at("b")) == "2*d^2");
    CHECK(to_text(found.at("c")) == "d^2");
    CHECK(to_text(formula::put_in(found, named("a*d"))) == "(2*d^2 + d^2)*d");
}

TEST_CASE("circular definitions are refused, and the circle is named") {
    const auto circle = [](const formula::Definitions& definitions) {
        try {
            (void)formula::put_into_each_other(definitions);
        } catch (const InputError& error) {
            return error.problem();
        }
        return std::string("none");
    };
    CHECK(circle({{"a", named("a")}}) == "the definitions are circular: a -> a");
    CHECK(circle({{"a", named("b")}, {"b", named("c + 1")}, {"c", named("2/b")}}) ==
          "the definitions are circular: b -> c -> b");
    CHECK(circle({{"a", named("b")}, {"b", named("c")}}) == "none");
    // The variable of a sum is not a definition.
    CHECK(circle({{"a", named("sum(a, a, 1, 3)")}}) == "none");
}

TEST_CASE("definitions that double at each step are refused, not written out") {
    formula::Definitions definitions;
    for (int k = 0; k < 60; ++k) {
        const std::string next = "y" + std::to_string(k + 1);
        definitions.emplace("y" + std::to_string(k), named(next + "+" + next));
    }
    CHECK_THROWS_AS((void)formula::put_into_each_other(definitions), Error);
}
