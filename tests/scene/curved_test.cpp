// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/precision/error.hpp"
#include "tests/scene/scene_text.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

using namespace edgeproof::scenes;

namespace {

std::string text_of(const std::string& profile, const std::string& load, const std::string& ask) {
    return "[profile]\nkind = \"piecewise\"\n" + profile + "\n[load]\n" + load +
           "\ncontact_modulus = \"7/3\"\n[ask]\nedges = [\"right\", \"left\"]\nterms = [1, 2]\n"
           "digits = 40\nu = [\"1e-60\", \"1e-3\", \"0.1\"]\ntolerance = \"2%\"\n" +
           ask + "\n";
}

const char* const tilted = "knots = [\"0\", \"1/3\"]\nslopes = [\"-1/10 + sinh(x)\", "
                           "\"x^2 + x/7\", \"10/63 + tanh(x - 1/3)\"]";

/// Returns the fault of a value that is not proved, or is wider than 10 units of the last printed
/// digit.
std::string curved_fault(const BoundedValue& v, const Digits& digits) {
    const PrintedValue p = printed(v, digits);
    if (!v.proved) {
        return "estimated by " + v.route + " ";
    }
    if (v.exactly) {
        return "";
    }
    const Ball unit = abs(v.value) * Ball(parse_decimal("1e-39"), 200);
    return certainly_less(Ball(v.value.radius(), 200), unit) && p.complete ? ""
                                                                           : "wide: " + p.bound;
}

std::string faults(const std::string& text) {
    const Scene scene = parsed(text);
    const SceneResult result = run_scene(scene);
    const Digits& digits = scene.ask.digits;
    std::string all;
    for (const Row& row : result.rows) {
        const Quantity quantity = row.asked.quantity;
        if (row_of(quantity).short_error) {
            all += row.value->proved ? "" : "error estimated";
        } else if (quantity != Quantity::x && quantity != Quantity::crossing) {
            all += curved_fault(*row.value, digits);
        }
    }
    return all;
}

} // namespace

TEST_CASE("curved slopes: pressures, coefficients and extents are proved, and narrow") {
    const std::string all = "quantities = [\"pressure\", \"coefficients\", \"extent\"]";
    CHECK(faults(text_of("symmetric = true\nslopes = [\"sinh(x)\"]", "P = \"1/3\"", all)) == "");
    CHECK(faults(text_of("symmetric = true\nslopes = [\"asinh(x) + x^2\"]", "a = \"3/4\"",
                         "quantities = [\"pressure\", \"coefficients\"]")) == "");
    // An edge on a knot, given exactly; also with a root there.
    CHECK(faults(text_of("symmetric = true\nknots = [\"3/4\"]\nslopes = [\"x^(3/2)\", "
                         "\"x^(3/2) + (x - 3/4)\"]",
                         "a = \"3/4\"", "quantities = [\"pressure\", \"coefficients\"]")) == "");
}

TEST_CASE("a curved slope under P, not symmetric: all that follows from both edges is proved" *
          doctest::test_suite("slow")) {
    CHECK(faults(text_of(tilted, "P = \"1/3\"",
                         "quantities = [\"pressure\", \"coefficients\", \"extent\"]")) == "");
}

TEST_CASE("hypot and atan2 are written with analytic functions; abs is refused") {
    const std::string ask = "quantities = [\"pressure\", \"coefficients\"]";
    const auto of = [&](const std::string& slope) {
        return text_of("symmetric = true\nslopes = [\"" + slope + "\"]", "a = \"3/4\"", ask);
    };
    for (const auto& [given, plain] :
         {std::pair{"hypot(1, x) - 1", "sqrt(1 + x^2) - 1"}, {"atan2(x, 1)", "atan(x)"}}) {
        CAPTURE(given);
        CHECK(faults(of(given)) == "");
        const SceneResult one = run_scene(parsed(of(given)));
        const SceneResult other = run_scene(parsed(of(plain)));
        CHECK(overlaps(one.points()[1].at(Quantity::p).value,
                       other.points()[1].at(Quantity::p).value));
    }
    for (const char* slope : {"abs(x)^3", "max(0, x - 1/2)", "x + step(x - 1/2)"}) {
        CAPTURE(slope);
        CHECK_THROWS_WITH_AS(parsed(of(slope)), doctest::Contains("write it as pieces"),
                             InputError);
    }
}

TEST_CASE("a slope that is not proved to rise, and one that falls, are refused") {
    const std::string ask = "quantities = [\"pressure\", \"coefficients\"]";
    CHECK_THROWS_WITH_AS(
        faults(text_of("symmetric = true\nslopes = [\"x^3 - 9*x^2/10 + 27*x/100\"]", "a = \"3/4\"",
                       ask)),
        doctest::Contains("scene.toml:1: g' could not be proved to rise"), InputError);
    // The same slope in another form.
    CHECK(faults(text_of("symmetric = true\nslopes = [\"(x - 3/10)^3 + 27/1000\"]", "a = \"3/4\"",
                         ask)) == "");
    CHECK_THROWS_WITH_AS(
        faults(text_of("symmetric = true\nslopes = [\"x + sin(1000*x)/900\"]", "a = \"3/4\"", ask)),
        doctest::Contains("scene.toml:1: g' decreases near x = -0.5625"), InputError);
    // At every power of 2 the rate is 1 + (1024 pi/3/950) cos, at least 0.4: samples there do not
    // show the decrease.
    CHECK_THROWS_WITH_AS(
        faults(text_of("symmetric = true\nslopes = [\"x + sin(2*pi/3*1024*x)/1900\"]",
                       "a = \"3/4\"", ask)),
        doctest::Contains("scene.toml:1: g' decreases near x = "), InputError);
}

// By symmetry p at the origin and at x = 1/2 does not depend on the edge from which it is counted.
TEST_CASE("places on a knot of a curved contact whose edges are computed are enclosed") {
    const std::string profile = "symmetric = true\nknots = [\"1/2\"]\n"
                                "slopes = [\"x + x^3\", \"5/8 + 2*(x - 1/2)\"]";
    const auto at = [&](const std::string& x) {
        return run_scene(parsed("[profile]\nkind = \"piecewise\"\n" + profile +
                                "\n[load]\nP = \"1/2\"\ncontact_modulus = \"1\"\n[ask]\nedges = "
                                "[\"right\"]\ndigits = 20\nx = [\"" +
                                x + "\"]\n"))
            .points()[0]
            .at(Quantity::p);
    };
    for (const char* knot : {"0", "1/2", "-1/2"}) {
        CAPTURE(knot);
        const BoundedValue p = at(knot);
        CHECK(p.proved);
        CHECK(p.value.relative_accuracy_bits() > 60);
        // p is continuous: its change over 1e-12 is at most of the order of 1e-11.
        const BoundedValue near = at(std::string(knot) + " + 1e-12");
        CHECK(abs(Ball(p.value - near.value)).upper() < Real("1e-10"));
    }
}
