// SPDX-License-Identifier: BSD-3-Clause
// Every value is proved, and narrower than 10 units of its last digit: all profiles, with edges on
// knots, flats that hold the minimum, and where digits are lost.
#include "edgeproof/precision/error.hpp"
#include "tests/scene/scene_words.hpp"

#include <doctest/doctest.h>

using namespace edgeproof::scenes;

namespace {

/// A scene in words, without [ask], and the places from both edges.
struct Sampled {
    std::string words;
    std::string u = "0.1";
};

/// Returns the fault of a value that is not proved, or not printed within 10 units of the last
/// digit; empty if there is none.
std::string fault(const BoundedValue& v, const Digits& digits) {
    const PrintedValue p = printed(v, digits);
    if (!v.proved) {
        return "estimated by " + v.route + " ";
    }
    if (v.exactly) {
        return "";
    }
    if (!v.value.is_finite()) {
        return "not finite";
    }
    if (contains_zero(v.value)) {
        return parse_decimal(p.bound) < parse_decimal("1e-300") ? "" : "not zero for certain";
    }
    const Ball unit = abs(v.value) / pow_int(Ball(10, 200), static_cast<long>(digits.count) - 1);
    return certainly_less(Ball(v.value.radius(), 200), unit) && p.complete ? ""
                                                                           : "wide: " + p.bound;
}

/// Checks that x is a - u at the right edge and u - b at the left one.
void check_places(const SceneResult& result) {
    for (const RowsAt& row : result.points()) {
        const Ball u = ball_of(*row.row(Quantity::x).asked.u, 1500);
        const Ball x = row.edge() == Edge::right ? result.at(Quantity::a).value - u
                                                 : u - result.at(Quantity::b).value;
        CHECK(overlaps(row.at(Quantity::x).value, x));
    }
}

std::string faults(const std::string& words) {
    const Scene scene = made(words);
    const SceneResult result = run_scene(scene);
    std::string all;
    for (const Row& row : result.rows) {
        const Quantity quantity = row.asked.quantity;
        const bool short_one = row_of(quantity).short_error || quantity == Quantity::x ||
                               quantity == Quantity::q_local || quantity == Quantity::crossing;
        all += !row.value  ? "missing"
               : short_one ? (row.value->proved ? "" : "estimated error")
                           : fault(*row.value, scene.ask.digits);
    }
    CHECK(result.points().size() == result.plan.points * scene.ask.edges.size());
    if (scene.ask.wants(QuantityGroup::contact)) {
        check_places(result);
    }
    return all;
}

const std::string of_both_edges = " edges=right;left terms=1;3 digits=40 u=1e-320;1e-60;";
const std::string sheared =
    " Q=pi*(1+1e-40) bulk_tension=-4 quantities=pressure;shear;coefficients;"
    "contact";
const std::string with_extents =
    " edges=right;left terms=1;2 digits=20 tolerance=1% u=1e-3;0.1 quantities=pressure;"
    "coefficients;extent;contact";

} // namespace

TEST_CASE("every value has a proved bound, and none is wider than 10 units of the last digit") {
    for (const Sampled& s : {
             Sampled{"power-law m=0 C=0.3 a=0.7", "0.7-1e-30;0.7+1e-300"},
             {"power-law m=1e-10 C=1 a=0.7", "0.7;0.7-1e-30"},
             {"power-law m=0.62500000000000000001 C=1 a=0.7", "0.7;0.3"},
             {"power-law m=10000 C=1 a=0.7", "0.7;0.69;1e-4"},
             {"power-law m=7/3 C=2 P=1e-9", "1e-5"},
             {"flat-and-rounded t=1e-15 R=1 a=1", "1;1-1e-15;1-2e-15"},
             {"flat-and-rounded t=1-1e-15 R=1 a=1", "1;1e-15;1.1e-15"},
             {"flat-and-rounded t=pi/8 R=1 a=1", "1-pi/8;1-pi/8+1e-30;1-pi/8-1e-30"},
             {"flat-and-rounded t=1 R=1 P=1e-40", "0.5"},
             {"tilted-wedge phi=pi/16 alpha=asin(1e-30/(2-1e-30))/8 a=1", "1-1e-20"},
             {"tilted-wedge phi=pi/16 alpha=asin((1-1e-30)/(1+1e-30))/8 a=1", "1e-31"},
             {"tilted-flat-and-rounded alpha=1e-25 t=1 R=2 a=0.5", "0.5;0.7"},
             {"flat-and-rounded t=4e-10 R=1e-9 a=1e-9 E=1e12", "6e-10;1e-9"},
             {"tilted-flat-and-rounded t=1 R=2 P=0.3 M=-0.2", "0.5"},
             {"piecewise knots=-1/3;0;1/2 slopes=3*x;2*x-1/3;x;1/4+x/2 a=3/4", "1/4;3/4-1e-40"},
         }) {
        CAPTURE(s.words);
        CHECK(faults(s.words + of_both_edges + s.u + sheared) == "");
    }
}

TEST_CASE("edges on a knot or a corner, flats with the minimum inside: all is proved") {
    const std::string corner = "piecewise knots=-1;1 slopes=2*x;x;2*x";
    const std::string bend = "piecewise knots=-1 slopes=x/5+(x+1);x/5";
    const std::string leaning = "piecewise knots=-1;0 slopes=-2/15+(x+1)/7;-2/15;1/15";
    const std::string flat = "piecewise knots=-1/2;1 slopes=x+1/2;0;x-1";
    const std::string one_sided = "piecewise knots=0;1 slopes=x;0;2*(x-1)";
    for (const std::string& words :
         {std::string("tilted-flat-and-rounded alpha=0.1 t=0.5 R=2 P=pi*0.005"), corner + " a=1",
          corner + " P=pi/4", bend + " a=1", bend + " P=pi/20", leaning + " a=3",
          leaning + " P=sqrt(3)/10", flat + " P=0.1", flat + " P=1e-6", flat + " a=5/4",
          one_sided + " P=0.1", one_sided + " a=3/2"}) {
        CAPTURE(words);
        CHECK(faults(words + with_extents) == "");
    }
}

namespace {
const std::string curved_ask = " E=7/3 edges=right;left terms=1;2 digits=40 u=1e-60;1e-3;0.1 "
                               "tolerance=2% quantities=pressure;coefficients";
} // namespace

TEST_CASE("curved slopes: pressures, coefficients and extents are proved, and narrow") {
    CHECK(faults("piecewise symmetric slopes=sinh(x) P=1/3" + curved_ask + ";extent") == "");
    CHECK(faults("piecewise symmetric slopes=asinh(x)+x^2 a=3/4" + curved_ask) == "");
    // An edge on a knot, given exactly; also with a root there.
    CHECK(faults("piecewise symmetric knots=3/4 slopes=x^(3/2);x^(3/2)+(x-3/4) a=3/4" +
                 curved_ask) == "");
    CHECK(faults("piecewise symmetric slopes=(x-3/10)^3+27/1000 a=3/4" + curved_ask) == "");
}

TEST_CASE("a curved slope under P, not symmetric: all that follows from both edges is proved" *
          doctest::test_suite("slow")) {
    CHECK(faults("piecewise knots=0;1/3 slopes=-1/10+sinh(x);x^2+x/7;10/63+tanh(x-1/3) P=1/3" +
                 curved_ask + ";extent") == "");
}

// P of flat-and-rounded at a = 1, t = 1/3 is (acos(1/3) - sqrt(8)/9)/2. The algebra does not know
// that acos(1/3) = atan(sqrt(8)), and no number of bits distinguishes a from 1.
TEST_CASE("an edge on a knot that cannot be proved: p is proved, and its series is refused") {
    const auto scene = [](const std::string& P) {
        return made("piecewise symmetric knots=1/3;1 slopes=0;x-1/3;3*x-7/3 P=(" + P +
                    "-sqrt(8)/9)/2" + with_extents);
    };
    const SceneResult known = run_scene(scene("acos(1/3)"));
    Scene other = scene("atan(sqrt(8))");
    CHECK_THROWS_WITH_AS((void)run_scene(other),
                         doctest::Contains("an edge may lie on a knot of g'"), BudgetError);
    other.ask.terms.clear();
    other.ask.quantities = {QuantityGroup::pressure, QuantityGroup::contact};
    const SceneResult result = run_scene(other);
    CHECK(known.at(Quantity::a).exactly == Rational(1));
    CHECK_FALSE(result.at(Quantity::a).exactly.has_value());
    for (const Row& row : result.rows) {
        CHECK(row.value->proved);
    }
    CHECK(overlaps(result.points()[0].at(Quantity::p).value,
                   known.points()[0].at(Quantity::p).value));
}

TEST_CASE("0 has the bound 0 only for values that are known to be 0") {
    const PrecisionScope scope(60);
    const Digits digits{20};
    CHECK(printed({Ball(0, 128), true, "r"}, digits).text == "0");
    CHECK(printed({Ball(0, 128), true, "r"}, digits).complete);
    CHECK(printed({Ball::around(Real(0), Real(1), 64), true, "r", Rational(0)}, digits).text ==
          "0");
    for (const bool proved : {false, true}) {
        const BoundedValue maybe{Ball::around(Real(0), Real("1e-400"), 64), proved, "r"};
        CHECK(printed(maybe, digits).text == "0");
        CHECK(parse_decimal(printed(maybe, digits).bound) >= parse_decimal("1e-400"));
        CHECK_FALSE(printed(maybe, digits).complete);
    }
}
