// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/symbolic/symbolic.hpp"
#include "edgeproof/formula/parse.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <string_view>

namespace {

const Symbols& names() {
    static const Symbols all = [] {
        Symbols s;
        for (const char* name : {"a", "b", "x", "Q", "sig0", "gam", "X", "eps"}) {
            s.add(name);
        }
        s.add_function("p", 1);
        return s;
    }();
    return all;
}

bool equivalent(std::string_view x, std::string_view y, bool symmetric = false) {
    SymbolicCase under;
    under.symmetric = symmetric;
    return surely_equal(parse(x, names()), parse(y, names()), under);
}

std::string ordered(std::string_view x) { return ordered_text(parse(x, names())); }

} // namespace

TEST_CASE("ordered text does not depend on the order of terms and factors, signs and quotients") {
    CHECK(ordered("a - eps*X") == ordered("-X*eps + a"));
    CHECK(ordered("a/(b/x)") == ordered("x*a/b"));
    CHECK(ordered("-(a - b)") == ordered("b - a"));
    CHECK(ordered("p(a*b) + 0") == ordered("p(b*a)"));
    CHECK(ordered("2*a/4") == ordered("a/2"));
    CHECK(ordered("a - b") != ordered("b - a"));
    CHECK(ordered("a/b") != ordered("b/a"));
    CHECK(ordered("2*a") != ordered("3*a"));
    CHECK(ordered("p(a - b)") != ordered("p(b - a)"));
    CHECK(ordered("a^b") != ordered("b^a"));
}

TEST_CASE("surely equal: by b = a, by symbols, and by a principal value that is zero") {
    CHECK(equivalent("integral(p(x), x, -a, a)", "integral(p(x), x, -b, a)", true));
    CHECK_FALSE(equivalent("integral(p(x), x, -a, a)", "integral(p(x), x, -b, a)"));
    CHECK(equivalent("(a + b)^2 - a^2", "b*(2*a + b)"));
    CHECK_FALSE(equivalent("(a + b)^2 - a^2", "b*(2*a - b)"));
    const char* full = "pv((Q + sig0*(2*s + b - a))/sqrt((a - s)*(s + b))/(s - x), s, -b, a, x)";
    CHECK(equivalent(full,
                     "pv((Q + sig0*(2*s + b + a))/sqrt((a - s)*(s + b))/(s - x), s, -b, a, x)"));
    CHECK(equivalent(full,
                     "pv((9*Q + sig0*(2*s + b - a))/sqrt((a - s)*(s + b))/(s - x), s, -b, a, x)"));
    CHECK_FALSE(equivalent(
        full, "pv((Q + sig0*(3*s + b - a))/sqrt((a - s)*(s + b))/(s - x), s, -b, a, x)"));
    CHECK_FALSE(equivalent(
        full, "pv((Q + sig0*(2*s + b + a))/sqrt((a - s)*(s + b))/(s - x), s, -b, x, x)"));
}

TEST_CASE("surely equal: terms that are odd about the middle of an interval") {
    const char* full =
        "integral(Q/sqrt((a-s)*(s+b)) + sig0*(2*s+b-a)/(8*sqrt((a-s)*(s+b))), s, -b, a)";
    CHECK(equivalent(full,
                     "integral(Q/sqrt((a-s)*(s+b)) + (2*s+b-a)/(8*sqrt((a-s)*(s+b))), s, -b, a)"));
    CHECK(equivalent(full, "integral(Q/sqrt((a-s)*(s+b)), s, -b, a)"));
    CHECK_FALSE(equivalent(
        full, "integral(Q/sqrt((a-s)*(s+b)) + sig0*(2*s+b+a)/(8*sqrt((a-s)*(s+b))), s, -b, a)"));
    CHECK_FALSE(equivalent(full, "integral(2*Q/sqrt((a-s)*(s+b)), s, -b, a)"));
    CHECK_FALSE(equivalent(full, "integral(Q/sqrt((a-s)*(s+b)), s, -b, b)"));
}

TEST_CASE("surely equal: a division by zero in symbols is not a proof") {
    CHECK_FALSE(equivalent("1/(a - b)", "1/(a + b)", true));
}
