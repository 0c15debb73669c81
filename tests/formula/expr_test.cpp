// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/formula/expr.hpp"

#include "edgeproof/formula/parse.hpp"
#include "edgeproof/precision/error.hpp"
#include "tests/support/namespaces.hpp"
#include "tests/support/table.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cstddef>
#include <random>
#include <string>
#include <unordered_set>
#include <vector>

namespace {

const Symbols text_symbols = [] {
    Symbols s{"a", "b", "s", "x", "y", "k", "P1", "s_1"};
    s.add_function("f", 1).add_function("g", 2);
    return s;
}();

Expr read(std::string_view text) { return parse(text, text_symbols); }

formula::Expr named(const std::string& text) {
    formula::Symbols symbols{"a", "b", "c", "d"};
    for (int k = 0; k <= 60; ++k) {
        symbols.add("y" + std::to_string(k));
    }
    return formula::parse(text, symbols);
}

/// Returns a random tree of at most `height` levels. It uses only the raw output of the engine, so
/// that a seed gives the same tree with every standard library.
Expr random_expr(std::mt19937_64& random, int height, const std::vector<std::string>& symbols) {
    const auto below = [&random](std::size_t n) { return static_cast<std::size_t>(random() % n); };
    const auto leaf = [&]() -> Expr {
        static const std::array numbers{Rational(0),    Rational(1),      Rational(2),
                                        Rational(1, 2), Rational(5, 4),   Rational(12345, 1000),
                                        Rational(3),    Rational(1, 1000)};
        const std::size_t n = below(5);
        return n < 2    ? Expr::number(numbers[below(numbers.size())])
               : n == 2 ? Expr::pi()
                        : Expr::symbol(symbols[below(symbols.size())]);
    };
    if (height <= 1) {
        return leaf();
    }
    const auto child = [&] { return random_expr(random, height - 1, symbols); };
    const std::size_t kind = below(10);
    const Expr x = child();
    switch (kind) {
    case 0:
        return leaf();
    case 1:
        return -x;
    case 2:
        return x + child();
    case 3:
        return x - child();
    case 4:
        return x * child();
    case 5:
        return x / child();
    case 6: {
        static const std::array exponents{Rational(2), Rational(-1), Rational(1, 2),
                                          Rational(-3, 2), Rational(3)};
        return pow(x, below(3) == 0 ? child() : Expr::number(exponents[below(exponents.size())]));
    }
    case 7: {
        static const std::array names{"sin", "atan", "exp", "tanh", "asinh", "abs", "sqrt", "log"};
        return Expr::call(names[below(names.size())], {x});
    }
    case 8:
        return Expr::call(below(2) == 0 ? "max" : "hypot", {x, child()});
    default:
        return x * x - x;
    }
}

} // namespace

TEST_CASE("expressions are printed as they would be written by hand") {
    // Each of these is already its own shortest text.
    for (const std::string& text : test::items(R"ITEMS(
        0   12   0.4   1e-30   2.5e12   1000000   Pi   a   -a   -2   -a^2   (-a)^2   a - b - x
        a - (b - x)   a + b + x   a + (b + x)   a/b/x   a/(b/x)   a*b/x   a*(b/x)   a^b^x   (a^b)^x
        a^(-1/2)   a^(3/2)   a^(-2)   -(a + b)   -(a*b)   -a*b   a*(-b)   a - (-b)   -(-a)
        (a + b)*(a - b)   sqrt(a^2 - b^2)   2*sqrt(2)/(3*a^(3/2)*Pi)*(5*P1/8 - a*x)   max(a, b, x)
        g(f(a), -b)   integral(f(s)/sqrt(a^2 - s^2), s, 0, a)   pv(f(s)/(s - x), s, -a, a, x)
        sum(a^k/k, k, 1, 10)
    )ITEMS")) {
        const Expr e = read(text);
        CAPTURE(text);
        CHECK(to_text(e) == text);
        CHECK(read(to_text(e)) == e);
    }
    test::for_pairs(R"ITEMS(
        a ^ -2 => a^(-2)   ((a)) + ((b*x)) => a + b*x   +a - +b => a - b   0.50 => 0.5
        0.0000001 => 1e-7   12000000000 => 1.2e10   0.000012 => 0.000012
        123.456e-9 => 1.23456e-7   1e100000 => 1e100000
    )ITEMS",
                    " => ", [](const auto& typed, const auto& printed) {
                        CHECK(to_text(read(typed)) == printed);
                    });
}

TEST_CASE("numbers that are no decimals become quotients") {
    CHECK(Expr::number(Rational(1, 3)) == read("1/3"));
    CHECK(Expr::number(Rational(-1, 3)) == read("-(1/3)"));
    CHECK(Expr::number(Rational(-5, 4)) == read("-1.25"));
    CHECK(*Expr::number(Rational(-22, 7)).rational() == Rational(-22, 7));
    CHECK_THROWS_AS((void)read("a").number(), Error);
}

TEST_CASE("random trees come back from their text") {
    std::mt19937_64 random(20240607);
    for (int i = 0; i < 4000; ++i) {
        const Expr e = random_expr(random, 6, {"a", "b", "x"});
        const std::string text = to_text(e);
        CAPTURE(text);
        const Expr back = read(text);
        CHECK(back == e);
        CHECK(back.hash() == e.hash());
        CHECK(to_text(back) == text);
    }
}

TEST_CASE("no pair of parentheses can be left out, but those around a sign") {
    std::mt19937_64 random(7);
    for (int i = 0; i < 300; ++i) {
        const Expr e = random_expr(random, 4, {"a", "b", "x"});
        const std::string text = to_text(e);
        CAPTURE(text);
        std::vector<std::size_t> open;
        for (std::size_t close = 0; close < text.size(); ++close) {
            if (text[close] == '(') {
                open.push_back(close);
            } else if (text[close] == ')') {
                const std::size_t from = open.back();
                open.pop_back();
                const bool call = from > 0 && (std::isalnum(text[from - 1]) != 0);
                if (call || text[from + 1] == '-') {
                    continue;
                }
                std::string without = text;
                without.erase(close, 1).erase(from, 1);
                CHECK_FALSE(read(without) == e);
            }
        }
    }
}

TEST_CASE("equality and hash see the structure, not the place") {
    CHECK(read("a+b") == read(" a  + (b)"));
    CHECK_FALSE(read("a + b") == read("b + a"));
    CHECK_FALSE(read("a - b") == read("a + b"));
    CHECK_FALSE(read("0.5") == read("1/2"));
    CHECK_FALSE(read("integral(s, s, 0, 1)") == read("integral(x, x, 0, 1)"));
    CHECK_FALSE(read("f(a)") == read("sqrt(a)"));
    std::unordered_set<Expr, ExprHash> set{read("a*b"), read("a * b"), read("a/b")};
    CHECK(set.size() == 2);
}

TEST_CASE("free names and functions") {
    using Names = std::set<std::string>;
    CHECK(free_symbols(read("Pi + 2")).empty());
    CHECK(free_symbols(read("a*sqrt(b) + f(x)")) == Names{"a", "b", "x"});
    CHECK(free_symbols(read("integral(s*x, s, 0, a) + y")) == Names{"a", "x", "y"});
    CHECK(free_symbols(read("s + integral(s, s, s, 1)")) == Names{"s"});
    CHECK(free_symbols(read("sum(integral(k*s, s, 0, k), k, 1, b)")) == Names{"b"});
    for (const char* text : {"a*sqrt(b) + f(x)", "integral(s*x, s, 0, a) + y", "s + f(a)",
                             "s + integral(s, s, s, 1)", "sum(integral(k*s, s, 0, k), k, 1, b)"}) {
        CAPTURE(text);
        const Names free = free_symbols(read(text));
        for (const char* name : {"a", "b", "k", "s", "x", "y", "f"}) {
            CHECK(holds_symbol(read(text), name) == free.contains(name));
        }
    }
    const Expr nested = read("f(g(1, sqrt(2))) + pv(f(s), s, 0, 1, x)");
    CHECK((holds_call(nested, "f") && holds_call(nested, "g") && holds_call(nested, "sqrt")));
    CHECK_FALSE((holds_call(nested, "x") || holds_call(nested, "pv")));
    CHECK(has_binder(read("1 + sum(k, k, 1, 3)")));
    CHECK_FALSE(has_binder(read("1 + f(a)")));
}

TEST_CASE("substitution") {
    CHECK(substitute(read("a + a*b"), "a", read("x + y")) == read("x + y + (x + y)*b"));
    CHECK(substitute(read("a^2"), "a", read("-b")) == read("(-b)^2"));
    CHECK(substitute(read("a"), "c", read("b")) == read("a"));
    // A bound name differs from a free one.
    CHECK(substitute(read("s + integral(s*a, s, 0, s)"), "s", read("b")) ==
          read("b + integral(s*a, s, 0, b)"));
    // A value that contains the bound name must not be captured.
    CHECK(substitute(read("integral(s*a, s, 0, a)"), "a", read("s")) ==
          read("integral(s_1*s, s_1, 0, s)"));
    const Expr twice = substitute(read("integral(s*a + s_1, s, 0, 1)"), "a", read("s"));
    CHECK(twice.arg(1).name() == "s_2");
    CHECK(free_symbols(twice) == std::set<std::string>{"s", "s_1"});
    // If nothing changes, the result is the same tree, including its place in the text.
    CHECK(substitute(read("  a"), "b", read("x")).offset() == 2);
}

TEST_CASE("builders refuse expressions that have no text") {
    CHECK_THROWS_AS((void)Expr::call("sqrt", {}), InputError);
    CHECK_THROWS_AS((void)Expr::call("atan2", {read("1")}), InputError);
    CHECK_THROWS_AS((void)Expr::call("integral", {read("1"), read("2"), read("3"), read("4")}),
                    InputError);
    CHECK_THROWS_AS((void)Expr::with_args(read("a + b"), {read("a")}), Error);
    Expr e = read("a");
    CHECK_THROWS_AS(
        [&] {
            for (int i = 0; i < 3000; ++i) {
                e = e + read("b");
            }
        }(),
        Error);
    CHECK(e.height() == Expr::max_height);
    Expr doubled = read("a");
    CHECK_THROWS_AS(
        [&] {
            for (int i = 0; i < 100; ++i) {
                doubled = doubled + doubled;
            }
        }(),
        Error);
    CHECK(doubled.height() < 25);
}

TEST_CASE("LaTeX") {
    const auto tex = [](const char* text) { return to_tex(read(text)); };
    CHECK(tex("2*sqrt(2)/(3*a^(3/2)*Pi)") == "\\frac{2 \\sqrt{2}}{3 a^{3/2} \\pi}");
    CHECK(tex("5*P1/8 - a*x") == "\\frac{5 P'(a)}{8} - a x");
    CHECK(tex("2*3") == "2 \\cdot 3");
    CHECK(tex("-(a + b)") == "-(a + b)");
    CHECK(tex("(a + b)^2") == "(a + b)^{2}");
    CHECK(tex("(a/b)^2") == "\\left(\\frac{a}{b}\\right)^{2}");
    CHECK(tex("1e-30*a") == "10^{-30} a");
    CHECK(to_tex(Expr::symbol("u_left_edge") * Expr::symbol("theta2")) ==
          "u_{\\mathrm{leftedge}} \\theta_{2}");
    CHECK(tex("integral(f(s), s, 0, a)") == "\\int_{0}^{a} f(s) \\,\\mathrm{d}s");
    // A name that `symbol` does not know is set as usual.
    CHECK(to_tex(read("P1*a"), [](std::string_view n) {
              return n == "P1" ? std::string("P_1") : std::string();
          }) == "P_1 a");
}

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
