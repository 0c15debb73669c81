// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/routes/extent.hpp"

#include "edgeproof/formula/parse.hpp"
#include "edgeproof/precision/error.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

namespace {

Exact exact(const char* text) { return Exact::parse(text); }

/// True if |x - y| <= 10^-digits |y|.
bool agree(const Real& x, const Real& y, unsigned digits) {
    const PrecisionScope scope(digits + 20);
    return abs(Real(x - y)) <= abs(y) * pow(Real(10), -static_cast<int>(digits));
}

NormalContact hertz(unsigned digits) {
    return {Profile::power_law(exact("1"), exact("1")), exact("1"), Load::right_edge(exact("3/2")),
            digits};
}

/// Returns p_local/p - 1 by a route that the scan does not use.
Real error_at(const NormalContact& contact, Edge edge, std::size_t n, const Real& u, Route route) {
    const PrecisionScope scope(u.precision());
    const auto c = contact.expansion(edge, n);
    Real sum = 0;
    for (std::size_t k = n; k-- > 0;) {
        sum = sum * u + c[k];
    }
    return sum * sqrt(u) / contact.pressure(edge, u, route).value - 1;
}

} // namespace

// p = C sqrt(u (2a - u)): with s = u/(2a), the ratio of one term to p is 1/sqrt(1-s), of two terms
// (1 - s/2)/sqrt(1-s).
TEST_CASE("Hertz: the exits of one and two terms are the roots of a linear and a quadratic") {
    for (const char* tol : {"1/100", "1/20", "1e-12", "1e-30"}) {
        const auto one = within_tolerance(hertz(50), Edge::right, 1, exact(tol));
        const auto two = within_tolerance(hertz(50), Edge::left, 2, exact(tol));
        const PrecisionScope scope(120);
        const Real k = 1 + exact(tol).to<Real>();
        const Real excess = k * k - 1;
        const Real s1 = excess / (k * k);
        const Real s2 = 2 * (sqrt(Real(excess * excess + excess)) - excess);
        CAPTURE(tol);
        CHECK(agree(one.first_exit, Real(3 * s1), 49));
        CHECK(agree(one.measure, Real(3 * s1), 49));
        CHECK(one.crossings.size() == 1);
        CHECK(one.leaves);
        CHECK(one.length == 3);
        CHECK(agree(two.first_exit, Real(3 * s2), 49));
        CHECK(two.crossings.size() == 1);
        CHECK(one.estimate < Real("1e-49"));
    }
}

TEST_CASE("a crossing satisfies its equation by the Barber-Mossakovskii route") {
    const NormalContact flat(Profile::flat_and_rounded(exact("2/5"), exact("1")), exact("1"),
                             Load::right_edge(exact("1")), 30);
    const NormalContact wedge(Profile::tilted_wedge(exact("pi/16"), exact("pi/20")), exact("1"),
                              Load::right_edge(exact("1")), 30);
    for (const NormalContact* contact : {&flat, &wedge}) {
        for (const Edge edge : {Edge::right, Edge::left}) {
            for (const std::size_t n : {1U, 2U, 3U, 5U}) {
                const auto e = within_tolerance(*contact, edge, n, exact("1/100"));
                REQUIRE(!e.crossings.empty());
                for (const Real& u : e.crossings) {
                    const Real f = error_at(*contact, edge, n, u, Route::barber_mossakovskii);
                    CAPTURE(n);
                    CHECK(agree(Real(abs(f)), Real("0.01"), 16)); // 0.01 itself is a short decimal
                    const PrecisionScope scope(60);
                    CHECK(agree(Real(abs(f)), Real(Real(1) / 100), 26));
                }
            }
        }
    }
}

TEST_CASE("the measure over a part of the contact, and an approximation that returns") {
    const NormalContact flat(Profile::flat_and_rounded(exact("4/5"), exact("1")), exact("1"),
                             Load::right_edge(exact("1")), 30);
    const auto half =
        within_tolerance(flat, Edge::right, 3, exact("1/100"), {exact("0"), exact("1/2")});
    const auto whole = within_tolerance(flat, Edge::right, 3, exact("1/100"));
    CHECK(half.first_exit == whole.first_exit);
    CHECK(half.measure <= whole.measure);
    // Count the points of a fine grid that are within the tolerance.
    const PrecisionScope scope(40);
    int inside = 0;
    const int teeth = 4000;
    for (int k = 0; k < teeth; ++k) {
        const Real u = (Real(k) + Real(1) / 2) / teeth;
        inside +=
            abs(error_at(flat, Edge::right, 3, u, Route::closed_form)) < Real(1) / 100 ? 1 : 0;
    }
    CHECK(abs(Real(half.measure - Real(inside) / teeth)) < Real(half.crossings.size()) / teeth);
    const auto inner =
        within_tolerance(flat, Edge::right, 3, exact("1/100"), {exact("1/1000"), exact("1/500")});
    CHECK_FALSE(inner.leaves);
    CHECK(agree(inner.measure, Real(Real(2) / 1000), 28));
    CHECK(agree(inner.first_exit, Real(Real(2) / 500), 28));
}

TEST_CASE("an extremum that barely reaches the tolerance between two points of the scan is found") {
    const NormalContact flat(Profile::flat_and_rounded(exact("2/5"), exact("1")), exact("1"),
                             Load::right_edge(exact("1")), 30);
    const PrecisionScope scope(40);
    // The two-term error has its maximum between the knot (u = 0.6) and the middle.
    const auto f = [&](const Real& u) {
        return error_at(flat, Edge::right, 2, u, Route::closed_form);
    };
    Real at = Real(7) / 8;
    Real best = f(at);
    for (Real step = Real(1) / 50; step > Real("1e-14");) {
        const Real l = f(Real(at - step));
        const Real r = f(Real(at + step));
        if (l <= best && r <= best) {
            step = step / 4;
        } else {
            at = l > r ? Real(at - step) : Real(at + step);
            best = l > r ? l : r;
        }
    }
    REQUIRE(best > Real(1) / 2);
    const auto level = [&](const Real& scale) {
        Rational q;
        const Real t = abs(best) * scale;
        mpfr_get_q(q.backend().data(), t.backend().data());
        return Exact::of(q);
    };
    const auto below = within_tolerance(flat, Edge::right, 2, level(Real(1) - Real("1e-9")));
    const auto above = within_tolerance(flat, Edge::right, 2, level(Real(1) + Real("1e-9")));
    CHECK(below.crossings.size() == above.crossings.size() + 2);
}

TEST_CASE("a crossing near a corner is found, or is the corner if the digits do not resolve it") {
    // A wedge is outside every tolerance at the apex.
    const NormalContact wedge(Profile::power_law(exact("1"), exact("0")), exact("1"),
                              Load::right_edge(exact("1")), 30);
    const auto e =
        within_tolerance(wedge, Edge::right, 60, exact("1/5"), {exact("0"), exact("1/2")});
    CHECK(e.crossings.size() == 1);
    CHECK(e.first_exit < 1);
    const PrecisionScope scope(60);
    const Real f = error_at(wedge, Edge::right, 60, e.first_exit, Route::closed_form);
    CHECK(agree(f, Real(Real(-1) / 5), 26));

    // A corner of 1e-9 on a parabola: the logarithm matters only within e^(-10^6) of it.
    const NormalContact faint(Profile::piecewise({exact("0")}, {parse("x - 1e-9", Symbols{"x"}),
                                                                parse("x + 1e-9", Symbols{"x"})}),
                              exact("1"), Load::right_edge(exact("1")), 30);
    const auto g = within_tolerance(faint, Edge::right, 40, exact("1/100"));
    REQUIRE(g.crossings.size() >= 2);
    CHECK(agree(g.crossings[0], faint.a(), 28));
    CHECK(agree(g.crossings[1], faint.a(), 28));
    CHECK(g.measure > 1);
}

TEST_CASE("an edge within 1e-20 of a knot exits on the scale of that gap") {
    const NormalContact near(Profile::flat_and_rounded(exact("1"), exact("1")), exact("1"),
                             Load::right_edge(exact("1 + 1e-20")), 30);
    const auto e = within_tolerance(near, Edge::right, 1, exact("1/100"));
    CHECK(e.first_exit < Real("1e-19"));
    CHECK(e.first_exit > Real("1e-23"));
    const Real f = error_at(near, Edge::right, 1, e.first_exit, Route::closed_form);
    CHECK(agree(Real(abs(f)), Real(exact("1/100").to<Real>()), 14));
}

TEST_CASE("a tolerance of 0, no terms, and a range beyond the contact are refused") {
    const auto c = hertz(20);
    CHECK_THROWS_AS((void)within_tolerance(c, Edge::right, 1, exact("0")), InputError);
    CHECK_THROWS_AS((void)within_tolerance(c, Edge::right, 1, exact("-1/2")), InputError);
    CHECK_THROWS_AS((void)within_tolerance(c, Edge::right, 0, exact("1/100")), InputError);
    CHECK_THROWS_AS(
        (void)within_tolerance(c, Edge::right, 1, exact("1/100"), {exact("1/2"), exact("1/4")}),
        InputError);
    CHECK_THROWS_AS(
        (void)within_tolerance(c, Edge::right, 1, exact("1/100"), {exact("0"), exact("11/10")}),
        InputError);
}

TEST_CASE("two crossings near an extremum that almost touches the tolerance are found") {
    // The tolerance is 1e-40 below a local maximum of the error, which was found separately
    // (hard-cases.toml).
    const Exact tolerance = exact("10.0150106162079383319964245839524852234540331102059096260117");
    const NormalContact contact(Profile::flat_and_rounded(exact("4/5"), exact("3")), exact("1"),
                                Load::right_edge(exact("1")), 60);
    const auto found = within_tolerance(contact, Edge::right, 1, tolerance);
    REQUIRE(found.crossings.size() >= 2);
    const PrecisionScope scope(80);
    const Real between = (found.crossings[0] + found.crossings[1]) / 2;
    CHECK(found.crossings[1] - found.crossings[0] < pow(Real(10), -18));
    CHECK(found.first_exit == found.crossings[0]);
    // Between the two the error exceeds the tolerance, by a route that the scan does not use.
    CHECK(abs(error_at(contact, Edge::right, 1, between, Route::singular_integral)) >
          tolerance.to<Real>());
}
