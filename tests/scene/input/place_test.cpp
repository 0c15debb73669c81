// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/precision/error.hpp"
#include "edgeproof/scene/input/place.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

using namespace edgeproof;
using scene::Distance;
using scene::Place;

namespace {

const Ball wide_a = Ball::from_interval(Real(2), Real(3), 64);
const Ball wide_b = Ball::from_interval(Real(4), Real(5), 64);

Distance from_right(const char* text, const Place::Names& names = {}) {
    return Place::parse(text, Place::From::edge, names).distance(contact::Edge::right);
}

} // namespace

TEST_CASE("a distance by the edges is enclosed as they are") {
    const Distance half = from_right("a/2");
    CHECK(!half.number());
    CHECK(!half.x());
    const Ball halves = half.enclosure(wide_a, wide_b, 64);
    CHECK(contains(halves, Rational(1)));
    CHECK(contains(halves, Rational(3, 2)));
    CHECK(halves.lower() > Real("0.999"));
    CHECK(halves.upper() < Real("1.501"));
    const Ball all = from_right("50%").enclosure(wide_a, wide_b, 64); // a fraction of a + b
    CHECK(contains(all, Rational(3)));
    CHECK(contains(all, Rational(4)));
    CHECK(!contains(all, Rational(5)));
}

TEST_CASE("x is a number where the edges cancel, and only there") {
    CHECK(from_right("a").x()->rational() == 0);
    CHECK(from_right("a - 1/3").x()->rational() == Rational(1, 3));
    CHECK(!from_right("b").x());
    CHECK(from_right("b", {{"b", formula::Expr::symbol("a")}}).x()->rational() == 0); // b equals a
    const Place place = Place::parse("1/4", Place::From::origin, {});
    CHECK(place.distance(contact::Edge::left).x()->rational() == Rational(1, 4));
    CHECK(!place.distance(contact::Edge::left).number());
}

TEST_CASE("known names are put in") {
    const formula::Expr two = formula::Expr::number(Rational(2));
    CHECK(from_right("a/2 + t", {{"a", two}, {"t", two}}).number()->rational() == 3);
    CHECK(!from_right("a/2 + t", {{"t", two}}).number());
    CHECK_THROWS_AS(from_right("c"), InputError);
    CHECK_THROWS_AS(from_right("sum(k, k, 1, 3)*a"), InputError);
    CHECK_THROWS_AS((void)Place::parse("10%", Place::From::origin, {}), InputError);
}

TEST_CASE("a distance in exact algebra") {
    const auto edge = [](std::string_view name) {
        return Form(name == "a" ? Rational(2, 3) : Rational(1, 6));
    };
    CHECK(from_right("3*a - 2*b + 1").exactly(edge).rational() == Rational(8, 3));
    CHECK(from_right("sqrt(a*b)").exactly(edge).rational() == Rational(1, 3));
}
