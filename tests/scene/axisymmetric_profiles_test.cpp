// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/precision/error.hpp"
#include "edgeproof/quadrature/tanh_sinh.hpp"
#include "edgeproof/scene/scene.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <functional>
#include <ios>
#include <string>
#include <vector>

namespace {

/// An axisymmetric contact, with g'(r) and its integral written down again.
struct BodyOfRevolution {
    const char* profile;
    const char* a;
    std::vector<const char*> knots; ///< inside the contact
    std::function<Real(const Real&)> slope;
    std::function<Real(const Real&)> profile_height;
};

std::vector<BodyOfRevolution> bodies_of_revolution() {
    const auto plus = [](const Real& x) { return Real(x > 0 ? x : Real(0)); };
    return {
        {"kind = \"flat-and-rounded\"\nt = \"2/5\"\nR = \"3\"",
         "1",
         {"2/5"},
         [=](const Real& r) { return Real(plus(r - Real(2) / 5) / 3); },
         [=](const Real& r) { return Real(pow(plus(r - Real(2) / 5), 2) / 6); }},
        // a cone with a rounded tip
        {"kind = \"piecewise\"\nsymmetric = true\nknots = [\"1/2\"]\nslopes = [\"x\", \"1/2\"]",
         "6/5",
         {"1/2"},
         [=](const Real& r) { return Real(r < Real(1) / 2 ? r : Real(1) / 2); },
         [=](const Real& r) { return Real(r < Real(1) / 2 ? r * r / 2 : r / 2 - Real(1) / 8); }},
        // a truncated cone: p is infinite at r = 1/3
        {"kind = \"piecewise\"\nsymmetric = true\nknots = [\"1/3\"]\nslopes = [\"0\", \"1/4\"]",
         "3/4",
         {"1/3"},
         [](const Real& r) { return Real(r < Real(1) / 3 ? Real(0) : Real(1) / 4); },
         [=](const Real& r) { return Real(plus(r - Real(1) / 3) / 4); }},
        // a cone at the apex, a corner and a change of the curvature
        {"kind = \"piecewise\"\nsymmetric = true\nknots = [\"1/4\", \"1/2\"]\n"
         "slopes = [\"1/10\", \"1/5 + x/3\", \"3/10 + 2*x/15\"]",
         "4/5",
         {"1/4", "1/2"},
         [](const Real& r) {
             return Real(r < Real(1) / 4   ? Real(1) / 10
                         : r < Real(1) / 2 ? Real(1) / 5 + r / 3
                                           : Real(3) / 10 + 2 * r / 15);
         },
         [](const Real& r) {
             const auto middle = [](const Real& x) { return Real(x / 5 + x * x / 6); };
             const auto last = [](const Real& x) { return Real(3 * x / 10 + x * x / 15); };
             const Real quarter = Real(1) / 4;
             const Real half = Real(1) / 2;
             const Real at_half = quarter / 10 + middle(half) - middle(quarter);
             return Real(r < quarter ? r / 10
                         : r < half  ? quarter / 10 + middle(r) - middle(quarter)
                                     : at_half + last(r) - last(half));
         }},
    };
}

scene::Scene revolved(const std::string& profile, const std::string& load,
                      const std::string& rest = "") {
    return scene::parse_scene("[profile]\ngeometry = \"axisymmetric\"\n" + profile + "\n[load]\n" +
                                  load + "\ncontact_modulus = \"7/3\"\n" + rest,
                              "revolved.toml");
}

Real revolved_number(const char* text) {
    return at_working_precision(formula::ball_of(Exact::parse(text), 220).midpoint());
}

std::string exact_text(const Real& x) { return x.str(45, std::ios_base::scientific); }

/// Pressures of one contact, by their radius.
class RevolvedPressure {
public:
    RevolvedPressure(const scene::Scene& s, const Real& a) : a_(a), values_(s, {first()}, digits) {}
    Real operator()(const Real& u) {
        scene::AskedValue asked{scene::Quantity::p};
        asked.u = Exact::parse(exact_text(u));
        const scene::BoundedValue p = values_.value(asked);
        CHECK(p.proved);
        return at_working_precision(p.value.midpoint());
    }

private:
    static scene::AskedValue first() {
        scene::AskedValue asked{scene::Quantity::p};
        asked.u = Exact::parse("1/9");
        return asked;
    }
    static constexpr scene::Digits digits{18, Rounding::nearest, false};
    Real a_;
    scene::SceneValues values_;
};

Real value_of_revolved(const scene::Scene& s, scene::Quantity quantity) {
    const scene::BoundedValue value =
        scene::SceneValues(s, {{quantity}}, {30, Rounding::nearest, false}).value({quantity});
    CHECK(value.proved);
    return at_working_precision(value.value.midpoint());
}

/// The integral of f over the parts of (0, a) between the places, which ascend.
Real over_parts(std::vector<Real> places, const Real& a,
                const std::function<Real(const Real& s, const Real& from_a)>& f) {
    places.insert(places.begin(), Real(0));
    places.push_back(a);
    Real sum = 0;
    for (std::size_t i = 0; i + 1 < places.size(); ++i) {
        const Real from = places[i];
        const Real width = places[i + 1] - from;
        const Real rest = a - places[i + 1];
        sum += width * quadrature::tanh_sinh<Real>(
                           [&](const Real& lo, const Real& hi) {
                               return f(Real(from + width * lo), Real(rest + width * hi));
                           },
                           {.target_digits = 18})
                           .value;
    }
    return sum;
}

} // namespace

namespace {

// The displacement of the surface of a half-space by a ring of pressure is an elliptic integral
// (johnson1985, eqs. 3.96, 3.97 and section 3.8): u_z(r) = 4/(pi E*) integral of p(s) s/(r + s)
// K(2 sqrt(r s)/(r + s)) ds. It must be delta - g(r) inside the contact, and gap + delta - g(r)
// outside.
void check_body_of_revolution(const BodyOfRevolution& body, const std::vector<const char*>& where) {
    const PrecisionScope precision(40);
    CAPTURE(std::string(body.profile));
    const Real a = revolved_number(body.a);
    const scene::Scene s = revolved(body.profile, std::string("a = \"") + body.a + "\"");
    RevolvedPressure p(s, a);
    std::vector<Real> knots;
    for (const char* knot : body.knots) {
        knots.push_back(revolved_number(knot));
    }
    const Real delta = value_of_revolved(s, scene::Quantity::delta);
    const Real pi = edgeproof::pi<Real>();
    const Real P =
        2 * pi * over_parts(knots, a, [&](const Real& r, const Real& u) { return Real(r * p(u)); });
    CHECK(abs(Real(P - value_of_revolved(s, scene::Quantity::P))) < P * Real("1e-11"));
    for (const char* place : where) {
        CAPTURE(std::string(place));
        const Real r = revolved_number(place);
        std::vector<Real> places(knots);
        if (r < a) {
            places.push_back(r);
            std::ranges::sort(places);
        }
        const Real lifted =
            4 / (pi * Real(7) / 3) * over_parts(places, a, [&](const Real& t, const Real& u) {
                const Real apart = abs(Real(r - t)) / (r + t); // k' of K(k)
                // K(k) by the arithmetic-geometric mean of 1 and k' (DLMF 19.8.5)
                Real mean = 1;
                Real root = apart;
                for (int k = 0; k < 12 && root != 0; ++k) {
                    const Real next = (mean + root) / 2;
                    root = sqrt(Real(mean * root));
                    mean = next;
                }
                return root == 0 ? Real(0) : Real(p(u) * t / (r + t) * pi / (2 * mean));
            });
        Real gap = 0;
        if (r > a) {
            scene::AskedValue asked{scene::Quantity::gap};
            asked.place = scene::Place::parse(place, scene::Place::From::origin, {})
                              .distance(contact::Edge::right);
            const scene::BoundedValue value =
                scene::SceneValues(s, {asked}, {25, Rounding::nearest, false}).value(asked);
            CHECK(value.proved);
            gap = at_working_precision(value.value.midpoint());
            CHECK(gap > 0);
        }
        const Real expected = delta - body.profile_height(r) + gap;
        CHECK(abs(Real(lifted - expected)) < delta * Real("1e-9"));
    }
}

} // namespace

TEST_CASE("the pressure of a body of revolution returns its profile, its load and its gap") {
    check_body_of_revolution(bodies_of_revolution()[0], {"3/2"});
}

TEST_CASE("the size of a body of revolution follows from its load and from its approach") {
    for (const BodyOfRevolution& body : bodies_of_revolution()) {
        CAPTURE(std::string(body.profile));
        const PrecisionScope precision(60);
        const scene::Scene s = revolved(body.profile, std::string("a = \"") + body.a + "\"");
        for (const auto& [key, quantity] :
             {std::pair{"P", scene::Quantity::P}, std::pair{"delta", scene::Quantity::delta}}) {
            const std::string value = exact_text(value_of_revolved(s, quantity));
            const scene::Scene inverse =
                revolved(body.profile, std::string(key) + " = \"" + value + "\"");
            const Real a = revolved_number(body.a);
            CHECK(abs(Real(value_of_revolved(inverse, scene::Quantity::a) - a)) <
                  a * Real("1e-27"));
        }
    }
}

// p = sum of c_k u^(k + 1/2), and p - (sum of n terms) decreases as u^(n + 1/2).
TEST_CASE("the expansion of a body of revolution converges to its pressure") {
    const PrecisionScope precision(60);
    for (const BodyOfRevolution& body : bodies_of_revolution()) {
        CAPTURE(std::string(body.profile));
        const scene::SceneResult result = run_scene(
            revolved(body.profile, std::string("a = \"") + body.a + "\"",
                     "[ask]\nterms = [1, 3, 6]\nu = [\"1e-4\", \"1e-8\"]\nedges = [\"right\"]"
                     "\ndigits = 40\n"));
        const std::vector<scene::RowsAt> points = result.points();
        REQUIRE(points.size() == 2);
        for (const std::size_t n : {1U, 3U, 6U}) {
            const auto error = [&](const scene::RowsAt& at) {
                return at_working_precision(at.at(scene::Quantity::rel, n).value.midpoint());
            };
            const Real order = log10(Real(error(points[0]) / error(points[1]))) / 4;
            CHECK(abs(Real(order - n)) < Real("0.02"));
        }
    }
}

// The program's own extent: within it the error stays within the tolerance, beyond it not.
TEST_CASE("the extent of three terms of a body of revolution") {
    const PrecisionScope precision(40);
    const std::vector<BodyOfRevolution> bodies = bodies_of_revolution();
    for (const BodyOfRevolution& body : {bodies[0]}) {
        CAPTURE(std::string(body.profile));
        const std::string load = std::string("a = \"") + body.a + "\"";
        const scene::SceneResult found = run_scene(
            revolved(body.profile, load,
                     "[ask]\nterms = 3\ntolerance = \"2%\"\nquantities = [\"extent\"]\nedges = "
                     "[\"right\"]\n"));
        const scene::Row* extent =
            found.at_edges(scene::QuantityGroup::extent).at(0).find(scene::Quantity::extent, 3);
        REQUIRE(extent != nullptr);
        CHECK(extent->value->proved);
        const Real u = at_working_precision(extent->value->value.midpoint());
        for (const auto& [factor, within] :
             {std::pair{"0.999999", true}, std::pair{"1.000001", false}}) {
            const std::string place = exact_text(Real(u * Real(factor)));
            const scene::SceneResult at = run_scene(
                revolved(body.profile, load,
                         "[ask]\nterms = 3\nu = [\"" + place + "\"]\nedges = [\"right\"]\n"));
            CHECK((at.points()[0].at(scene::Quantity::rel, 3).value.midpoint() < Real("0.02")) ==
                  within);
        }
    }
}

// johnson1985, eq. 3.42a: u_z = (1/(pi R))[(2 a^2 - r^2) arcsin(a/r) + a sqrt(r^2 - a^2)] outside
// the contact of a sphere, so that the gap is r^2/(2 R) - a^2/R + u_z.
TEST_CASE("the gap outside the contact of a sphere") {
    const Rational r(5, 4);
    const scene::SceneResult result =
        run_scene(revolved("kind = \"hertz\"\nR = \"2\"", "a = \"1\"",
                           "[ask]\nx = [\"5/4\"]\nquantities = [\"displacement\"]\n"));
    const scene::Row* gap = result.find(scene::Quantity::gap);
    REQUIRE(gap != nullptr);
    CHECK(gap->value->proved);
    const long bits = 300;
    const Ball outside =
        (Ball(Rational(2) - r * r, bits) * asin(Ball(1 / r, bits)) + sqrt(Ball(r * r - 1, bits))) /
        (Ball::pi(bits) * 2);
    CHECK(overlaps(gap->value->value, Ball(r * r / 4 - Rational(1, 2), bits) + outside));
    CHECK(gap->value->value.relative_accuracy_bits() > 160);
}

// johnson1985, section 7.2: the stick radius of a sphere is a (1 - Q/(f P))^(1/3), and
// q = f p_0 (sqrt(1 - r^2/a^2) - (c/a) sqrt(1 - r^2/c^2)) inside it.
TEST_CASE("partial slip of a sphere") {
    const long bits = 300;
    const scene::SceneResult result = run_scene(
        revolved("kind = \"hertz\"\nR = \"1/2\"", "P = \"7/9\"", // E* = 7/3: a^3 = 1/8
                 "[shear]\nQ = \"7/36\"\nfriction = \"1/2\"\n[ask]\nu = [\"1/100\", \"2/5\"]\n"
                 "edges = [\"right\"]\nquantities = [\"pressure\", \"shear\"]\n"));
    const Ball c = pow(Ball(Rational(1, 2), bits), Rational(1, 3)) / 2; // Q/(f P) = 1/2
    CHECK(overlaps(result.find(scene::Quantity::stick_a)->value->value, c));
    const std::vector<scene::RowsAt> points = result.points();
    const Ball p_0 = Ball(Rational(7, 6), bits) / Ball::pi(bits) * 4; // 3 P/(2 pi a^2)
    const auto root = [&](const Rational& x) { return sqrt(Ball(1, bits) - Ball(x * x, bits)); };
    const Rational slips = 1 - Rational(2, 100);
    CHECK(overlaps(points[0].at(scene::Quantity::q).value, p_0 * root(slips) / 2));
    const Ball x = Ball(Rational(1, 10), bits) / c;
    const Ball inner = c * 2 * sqrt(Ball(1, bits) - x * x);
    CHECK(
        overlaps(points[1].at(scene::Quantity::q).value, p_0 * (root(Rational(1, 5)) - inner) / 2));
    CHECK(points[1].at(scene::Quantity::q).proved);
}

// Cattaneo, Mindlin, Ciavarella: the stick radius c carries P - Q/f, and q = f (p - p*) carries Q.
TEST_CASE("partial slip of bodies of revolution" * doctest::test_suite("slow")) {
    const PrecisionScope precision(40);
    for (const BodyOfRevolution& body : bodies_of_revolution()) {
        CAPTURE(std::string(body.profile));
        const Real a = revolved_number(body.a);
        const std::string load = std::string("a = \"") + body.a + "\"";
        const Real P = value_of_revolved(revolved(body.profile, load), scene::Quantity::P);
        const std::string shear =
            "[shear]\nQ = \"" + exact_text(Real(P / 5)) + "\"\nfriction = \"1/2\"\n";
        const scene::Scene s = revolved(body.profile, load, shear);
        const Real c = value_of_revolved(s, scene::Quantity::stick_a);
        const Real inner = value_of_revolved(
            revolved(body.profile, "a = \"" + exact_text(c) + "\""), scene::Quantity::P);
        CHECK(abs(Real(inner - P * 3 / 5)) < P * Real("1e-25"));
        scene::AskedValue first{scene::Quantity::q};
        first.u = Exact::parse("1/9");
        scene::SceneValues values(s, {first}, {20, Rounding::nearest, false});
        std::vector<Real> places{c};
        for (const char* knot : body.knots) {
            places.push_back(revolved_number(knot));
        }
        std::ranges::sort(places);
        const Real Q =
            2 * edgeproof::pi<Real>() * over_parts(places, a, [&](const Real& r, const Real& u) {
                scene::AskedValue asked{scene::Quantity::q};
                asked.u = Exact::parse(exact_text(u));
                return Real(r * at_working_precision(values.value(asked).value.midpoint()));
            });
        CHECK(abs(Real(Q - P / 5)) < P * Real("1e-10"));
    }
}

TEST_CASE("a body of revolution at its greatest pressure") {
    // The rounded tip of a cone has its greatest pressure on the axis.
    const scene::Scene s = revolved(bodies_of_revolution()[1].profile, "a = \"6/5\"");
    scene::AskedValue asked{scene::Quantity::p};
    asked.u = Exact::parse("6/5");
    const Ball on_axis =
        scene::SceneValues(s, {asked}, {20, Rounding::nearest, false}).value(asked).value;
    const Ball greatest =
        scene::SceneValues(s, {{scene::Quantity::p_max}}, {20, Rounding::nearest, false})
            .value({scene::Quantity::p_max})
            .value;
    CHECK(overlaps(on_axis, greatest));
}

TEST_CASE("a pressure at a corner of a body of revolution is infinite") {
    for (const char* place : {"u = [\"1\"]", "u = [\"1/2\"]", "x = [\"-1/2\"]"}) {
        CAPTURE(place);
        std::string message;
        try {
            (void)run_scene(revolved("kind = \"piecewise\"\nsymmetric = true\nknots = [\"1/2\"]\n"
                                     "slopes = [\"1/8\", \"1/4\"]",
                                     "a = \"1\"", std::string("[ask]\n") + place + "\n"));
        } catch (const InputError& error) {
            message = error.what();
        }
        CHECK(message.find("infinite at a corner") != std::string::npos);
    }
}
