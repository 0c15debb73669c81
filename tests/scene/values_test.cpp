// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/scene/scene_text.hpp"

#include "edgeproof/precision/error.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace edgeproof::scenes;

namespace {

std::string p_text(const RowsAt& row, const Digits& digits) {
    return printed(row.at(Quantity::p), digits).text;
}

/// Returns sqrt(q), q < 1, to 50 digits after the leading zeros, using only the integer square
/// root.
std::string root_digits(const Rational& q, unsigned places) {
    using namespace boost::multiprecision;
    const Rational scaled = q * Rational(pow(Integer(100), places));
    Integer root = sqrt(Integer(numerator(scaled) / denominator(scaled)));
    // Round to nearest: compare the square of the next half unit.
    const Rational half = Rational(root) + Rational(1, 2);
    if (half * half < scaled) {
        ++root;
    }
    return root.str();
}

std::string digits_only(std::string text) {
    text.erase(std::remove(text.begin(), text.end(), '.'), text.end());
    text = text.substr(0, text.find('e'));
    return text.substr(text.find_first_not_of('0'));
}

} // namespace

TEST_CASE("Hertz: p = sqrt(u (2 - u))/2, by integer square roots") {
    const Scene scene =
        parsed(hertz("1", "u = [\"1e-30\", \"1e-3\", \"0.1\", \"1/3\", \"1.7\"]\n"));
    const SceneResult result = run_scene(scene);
    for (const RowsAt& row : result.points()) {
        const Exact& distance = *row.row(Quantity::x).asked.u;
        CAPTURE(distance.text());
        const Rational u = distance.rational();
        const Rational square = u * (2 - u) / 4;
        // Enough places for 50 digits after the leading zeros of p.
        const std::string text = p_text(row, scene.ask.digits);
        unsigned places = 50;
        while (root_digits(square, places).size() < 50) {
            ++places;
        }
        CHECK(digits_only(text) == root_digits(square, places));
        CHECK(row.at(Quantity::p).proved);
        CHECK(printed(row.at(Quantity::p), scene.ask.digits).complete);
    }
}

TEST_CASE("Hertz where p is a decimal: the exact text, each way of rounding") {
    // 3-4-5 triangles: u = 1/5, 2/5, 1 give p = 3/10, 2/5, 1/2.
    const std::string text = hertz("1", "u = [\"1/5\", \"2/5\", \"1\"]\ndigits = 12\n");
    for (const Rounding mode : {Rounding::nearest, Rounding::down, Rounding::up}) {
        Scene scene = parsed(text);
        scene.ask.digits.rounding = mode;
        const SceneResult result = run_scene(scene);
        const char* const expected[] = {"0.300000000000", "0.400000000000", "0.500000000000"};
        for (std::size_t i = 0; i < 3; ++i) {
            const PrintedValue p = printed(result.points()[i].at(Quantity::p), scene.ask.digits);
            const Rational exactly = parse_decimal(expected[i]);
            const Rational value = parse_decimal(p.text);
            CHECK(p.text == expected[i]);
            CHECK(abs(Rational(value - exactly)) <= parse_decimal(p.bound));
            // One unit of the last place, rounded up to the two digits of the bound.
            CHECK(parse_decimal(p.bound) <= parse_decimal("1.1e-12"));
        }
        CHECK(printed(result.points()[1].at(Quantity::x), scene.ask.digits).text ==
              "0.600000000000");
        CHECK(printed(result.points()[2].at(Quantity::x), scene.ask.digits).text == "0");
    }
}

TEST_CASE("Hertz's coefficients, by hand from sqrt(1 - u/(2a))") {
    // a = 2: p = sqrt(u) sqrt(1 - u/4) = sqrt(u) (1 - u/8 - u^2/128 - u^3/1024 - 5 u^4/32768 ...).
    const Scene scene = parsed(
        hertz("2", "edges = [\"left\", \"right\"]\nterms = 5\nquantities = [\"coefficients\"]\n"));
    const SceneResult result = run_scene(scene);
    REQUIRE(result.at_edges(QuantityGroup::coefficients).size() == 2);
    const Rational expected[] = {Rational(1), Rational(-1, 8), Rational(-1, 128),
                                 Rational(-1, 1024), Rational(-5, 32768)};
    for (const RowsAt& edge : result.at_edges(QuantityGroup::coefficients)) {
        CHECK(edge.find(Quantity::c, 5) == nullptr);
        CHECK(edge.find(Quantity::s, 0) == nullptr);
        for (std::size_t k = 0; k < 5; ++k) {
            const BoundedValue& c = edge.at(Quantity::c, k);
            CHECK(contains(c.value, expected[k]));
            CHECK(c.proved);
            CHECK(parse_decimal(printed(c, scene.ask.digits).text) == expected[k]);
        }
    }
}

TEST_CASE("Hertz within 1 %: u = 2a (1 - 1.01^-2) for one term") {
    Scene scene = parsed(hertz("1", "terms = 1\ntolerance = \"1%\"\nprocess_zone = \"0.039\"\n"
                                    "digits = 30\n"));
    const SceneResult result = run_scene(scene);
    REQUIRE(result.at_edges(QuantityGroup::extent).size() == 1);
    const RowsAt extent = result.at_edges(QuantityGroup::extent)[0];
    const BoundedValue& first_exit = extent.at(Quantity::extent, 1);
    const Rational exit = 2 * (1 - Rational(10000, 10201));
    CHECK(printed(first_exit, scene.ask.digits).text == to_decimal(exit, 30, Rounding::nearest));
    CHECK(printed(extent.at(Quantity::extent_fraction, 1), scene.ask.digits).text ==
          to_decimal(Rational(exit / 2), 30, Rounding::nearest));
    CHECK(first_exit.proved);
    CHECK(covers_zone(scene, first_exit)); // 0.0394... > 0.039
    scene.ask.process_zone = Exact::parse("0.0395");
    CHECK_FALSE(covers_zone(scene, first_exit));
}

TEST_CASE("extents of the same number of terms twice, at both edges: as many rows as asked for") {
    const SceneResult result = run_scene(parsed(hertz(
        "1", "edges = [\"right\", \"left\"]\nterms = [1, 1]\ntolerance = \"1%\"\ndigits = 10\n")));
    for (const RowsAt& edge : result.at_edges(QuantityGroup::extent)) {
        CHECK(std::ranges::count_if(edge, [](const Row& row) {
                  return row.asked.quantity == Quantity::extent;
              }) == 2);
    }
}

TEST_CASE("balls and quadratures agree, each within its own bound") {
    const std::string points = "edges = [\"right\", \"left\"]\nterms = [1, 3]\ndigits = 25\n"
                               "u = [\"1e-20\", \"0.01\", \"0.3\"]\n";
    const std::string flat =
        "[profile]\nkind = \"tilted-flat-and-rounded\"\nalpha = \"pi/16\"\nt = \"1\"\nR = \"2\"\n"
        "[load]\nP = \"1/5\"\ncontact_modulus = \"7/3\"\n[shear]\nQ = \"-0.1\"\n"
        "bulk_tension = \"0.4\"\n[ask]\n" +
        points;
    const std::string power = "[profile]\nkind = \"power-law\"\nm = \"5/2\"\nC = \"3\"\n[load]\n"
                              "a = \"0.7\"\ncontact_modulus = \"7/3\"\n[ask]\n" +
                              points;
    const std::string similar = tilted_wedge("[shear]\nQ = \"0.3\"\npath = \"together\"\n", points);
    for (const std::string& text : {flat, power, similar}) {
        const SceneResult balls = run_scene(parsed(text));
        const SceneResult reals = run_scene(parsed(text + "route = \"singular-integral\"\n"));
        for (std::size_t i = 0; i < balls.points().size(); ++i) {
            const BoundedValue x = balls.points()[i].at(Quantity::p);
            const BoundedValue y = reals.points()[i].at(Quantity::p);
            CHECK(overlaps(x.value, y.value));
            CHECK(x.proved);
            CHECK_FALSE(y.proved);
        }
    }
}

TEST_CASE("P and Q in proportion: q/p is Q/P at every point") {
    const SceneResult result = run_scene(
        parsed(tilted_wedge("[shear]\nQ = \"0.3\"\npath = \"together\"\n",
                            "u = [\"1e-9\", \"0.2\"]\nquantities = [\"pressure\", \"shear\", "
                            "\"contact\", \"coefficients\"]\nterms = 2\n")));
    const Ball expected = Ball(Rational(3, 10), 300) / result.at(Quantity::P).value;
    for (const RowsAt& row : result.points()) {
        CHECK(overlaps(row.at(Quantity::q).value / row.at(Quantity::p).value, expected));
    }
    CHECK(overlaps(result.at_edges(QuantityGroup::coefficients)[0].at(Quantity::s, 1).value /
                       result.at_edges(QuantityGroup::coefficients)[0].at(Quantity::c, 1).value,
                   expected));
    // P of the wedge by hand: E* phi a sqrt(gamma), gamma = (1 - sin)/(1 + sin) of pi alpha/(2 phi)
    // = pi/10, whose sine is (sqrt 5 - 1)/4 (moore-hills.tex, line 301).
    const PrecisionScope scope(60);
    const Real sine = (sqrt(Real(5)) - 1) / 4;
    const Real P = Real(1) / 5 * sqrt(Real((1 - sine) / (1 + sine)));
    CHECK(contains(result.at(Quantity::P).value, Ball(P, 180)) ==
          contains(result.at(Quantity::P).value, P));
    CHECK(abs(Real(result.at(Quantity::P).value.midpoint() - P)) < Real("1e-50"));
}

TEST_CASE("the shear of a given contact, by hand") {
    // a = b = 1, Q = pi, sigma_0 = 8: q = (1 + 2x)/sqrt(1 - x^2). At x = 3/5, which is u = 2/5 from
    // the right edge, q = 11/4; at x = -3/5, from the left edge, q = -1/4.
    const std::string text = "[profile]\nkind = \"power-law\"\nm = \"1\"\nC = \"1\"\n[load]\n"
                             "a = \"1\"\ncontact_modulus = \"1\"\n[shear]\nQ = \"pi\"\n"
                             "bulk_tension = \"8\"\n[ask]\nedges = [\"right\", \"left\"]\n"
                             "u = \"2/5\"\nterms = 1\ndigits = 20\n";
    const Scene scene = parsed(text);
    const SceneResult result = run_scene(scene);
    REQUIRE(result.points().size() == 2);
    CHECK(printed(result.points()[0].at(Quantity::q), scene.ask.digits).text ==
          "2.7500000000000000000");
    CHECK(printed(result.points()[1].at(Quantity::q), scene.ask.digits).text ==
          "-0.25000000000000000000");
    // K_II = (Q/pi +- sigma_0 (a + b)/8)/sqrt(a + b) = 3/sqrt 2 and -1/sqrt 2; divided by
    // sqrt(2/5): 3 sqrt 5/2 = 3.3541..., -sqrt 5/2.
    CHECK(printed(result.points()[0].at(Quantity::q_local, 1), scene.ask.digits).text ==
          "3.3541019662496845446");
    CHECK(printed(result.points()[1].at(Quantity::q_local, 1), scene.ask.digits).text ==
          "-1.1180339887498948482");
}

TEST_CASE("a value that vanishes is 0, with a bound far below the digits") {
    // For m = 5/8 the second coefficient is zero (moore-hills.tex, line 182).
    const Scene scene =
        parsed("[profile]\nkind = \"power-law\"\nm = \"5/8\"\nC = \"1\"\n[load]\na = \"1\"\n"
               "contact_modulus = \"1\"\n[ask]\nterms = 2\nquantities = [\"coefficients\"]\n");
    const SceneResult result = run_scene(scene);
    const PrintedValue c1 = printed(
        result.at_edges(QuantityGroup::coefficients)[0].at(Quantity::c, 1), scene.ask.digits);
    CHECK(c1.text == "0");
    CHECK(parse_decimal(c1.bound) < parse_decimal("1e-400"));
    CHECK(printed(result.at_edges(QuantityGroup::coefficients)[0].at(Quantity::c, 0),
                  scene.ask.digits)
              .complete);
}

TEST_CASE("the middle of a power law's contact is recognised exactly, and proved") {
    // Gauss's theorem gives p(0) = P'/(pi m), and moore-hills.tex line 144 gives P' = 11 (sqrt
    // pi/2) Gamma(6)/Gamma(13/2) a^10 for m = 10, Gamma(13/2) = 10395 sqrt(pi)/64. Hence p(0) = 128
    // a^10/(315 pi) = 0.129344969623889542720108709280519608510544981935101... a^10.
    const Scene scene =
        parsed("[profile]\nkind = \"power-law\"\nm = \"10\"\nC = \"1\"\n[load]\na = \"1/10\"\n"
               "contact_modulus = \"1\"\n[ask]\nu = [\"1/10\", \"0.0999999\"]\n");
    const SceneResult result = run_scene(scene);
    const BoundedValue middle = result.points()[0].at(Quantity::p);
    CHECK(overlaps(middle.value, Ball(Rational(128, 315), 400) / Ball::pi(400) *
                                     Ball(parse_decimal("1e-10"), 400)));
    CHECK(middle.proved);
    CHECK(printed(middle, scene.ask.digits).complete);
    CHECK(result.points()[1].at(Quantity::p).proved);
}

// x is exactly on a knot, which is a binary number or not: 26 values of the tables once had no
// proved bound.
TEST_CASE("on a knot the pressure is proved, and equals the one at a distance of 1e-60") {
    const auto flat = [](const std::string& t, const std::string& u) {
        return "[profile]\nkind = \"flat-and-rounded\"\nt = \"" + t +
               "\"\nR = \"1\"\n[load]\na = \"1\"\ncontact_modulus = \"1\"\n[ask]\nu = " + u + "\n";
    };
    const struct {
        const char* t;
        const char* u;
    } cases[] = {
        {"0.25", R"(["0.75", "0.75 + 1e-60"])"},
        {"0.4", R"(["0.6", "0.6 - 1e-60"])"},
        {"pi/8", R"(["1 - pi/8", "1 - pi/8 + 1e-60"])"},
        {"1/2", R"(["1", "1 + 1e-60"])"},
        {"0", R"(["1", "1 - 1e-60"])"},
    };
    for (const auto& c : cases) {
        CAPTURE(c.t);
        const Scene scene = parsed(flat(c.t, c.u));
        const SceneResult result = run_scene(scene);
        CHECK(result.points()[0].at(Quantity::p).proved);
        CHECK(printed(result.points()[0].at(Quantity::p), scene.ask.digits).complete);
        // |p'| < 200 there: moore-hills.tex eqn:SIEPressure has a logarithm of the distance.
        const Ball apart = abs(Ball(result.points()[0].at(Quantity::p).value -
                                    result.points()[1].at(Quantity::p).value));
        CHECK(certainly_less(apart, Ball(parse_decimal("1e-50"), 300)));
    }
    const SceneResult hertz_middle = run_scene(parsed(hertz("1", "u = \"1\"\n")));
    CHECK(contains(hertz_middle.points()[0].at(Quantity::p).value, Rational(1, 2)));
    CHECK(hertz_middle.points()[0].at(Quantity::p).proved);
}

TEST_CASE("the tilt found from P and M is proved, and so is all that follows") {
    // moore-hills.tex line 303: P = E* phi a sqrt(gamma), gamma = b/a. A tilt of 0 has M = 0.
    const auto text = [](const char* M) {
        return std::string("[profile]\nkind = \"tilted-wedge\"\nphi = \"pi/16\"\n[load]\nP = "
                           "\"1/10\"\nM = \"") +
               M +
               "\"\ncontact_modulus = \"1\"\n[ask]\nu = \"1e-6\"\nterms = 1\nquantities = "
               "[\"contact\", \"pressure\", \"coefficients\"]\n";
    };
    const Scene scene = parsed(text("-1/50"));
    const SceneResult result = run_scene(scene);
    const std::vector<BoundedValue> values{
        result.at(Quantity::alpha),
        result.at(Quantity::a),
        result.at(Quantity::b),
        result.at(Quantity::P),
        result.at(Quantity::M),
        result.points()[0].at(Quantity::p),
        result.at_edges(QuantityGroup::coefficients)[0].at(Quantity::c, 0)};
    for (const BoundedValue& v : values) {
        CHECK(v.proved);
        CHECK(printed(v, scene.ask.digits).complete);
    }
    const Ball P =
        Ball::pi(300) / 16 * sqrt(result.at(Quantity::a).value * result.at(Quantity::b).value);
    CHECK(overlaps(P, Ball(Rational(1, 10), 300)));
    const SceneResult upright = run_scene(parsed(text("0")));
    CHECK(printed(upright.at(Quantity::alpha), scene.ask.digits).text == "0");
    CHECK(upright.at(Quantity::alpha).proved);
    CHECK(overlaps(upright.at(Quantity::a).value, upright.at(Quantity::b).value));
}

TEST_CASE("a load that no contact carries, and points that have no pressure, name their lines") {
    const auto refused = [](const std::string& text, std::size_t line, const std::string& part) {
        try {
            (void)run_scene(parsed(text));
            FAIL("accepted");
        } catch (const InputError& error) {
            CAPTURE(error.what());
            CHECK(error.line() == line);
            CHECK(std::string(error.what()).find(part) != std::string::npos);
        }
    };
    refused(hertz("1", "u = [\"0.1\",\n\"2\"]\n"), 10, "on an edge"); // a + b = 2
    refused(hertz("1", "u = \"3\"\n"), 9, "outside the contact");
    std::string wedge = hertz("1", "u = \"1\"\n");
    wedge.replace(wedge.find("m = \"1\""), 7, "m = \"0\"");
    refused(wedge, 9, "infinite at a corner");
    // The slope is zero on the left.
    refused("[profile]\nkind = \"piecewise\"\nknots = [\"0\"]\nslopes = [\"0\", \"x\"]\n[load]\n"
            "a = \"1\"\ncontact_modulus = \"1\"\n[ask]\nu = \"0.1\"\n",
            6, "no position of the other edge closes this contact");
}
