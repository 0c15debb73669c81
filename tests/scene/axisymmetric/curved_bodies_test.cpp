// SPDX-License-Identifier: GPL-3.0-or-later
// Axisymmetric contacts with curved slopes: closed forms, and integrals of g' in Real.

#include "edgeproof/io/csv.hpp"
#include "edgeproof/io/text_file.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/rounding/text.hpp"
#include "edgeproof/quadrature/tanh_sinh.hpp"
#include "edgeproof/scene/scene.hpp"
#include "tests/scene/axisymmetric/abel_quadrature.hpp"
#include "tests/support/namespaces.hpp"
#include "tests/support/paths.hpp"

#include <doctest/doctest.h>

#include <optional>
#include <string>
#include <vector>

namespace {

constexpr unsigned digits_of_curved = 40;

scene::Scene curved_body(const std::string& knots, const std::string& slopes,
                         const std::string& load, const std::string& rest = "") {
    return scene::parse_scene("[profile]\ngeometry = \"axisymmetric\"\nkind = \"piecewise\"\n"
                              "symmetric = true\nknots = [" +
                                  knots + "]\nslopes = [" + slopes + "]\n[load]\n" + load +
                                  "\ncontact_modulus = \"7/3\"\n" + rest,
                              "curved.toml");
}

Ball value_of_curved(const scene::Scene& scene, const scene::AskedValue& asked,
                     unsigned digits = digits_of_curved) {
    const scene::BoundedValue value =
        scene::SceneValues(scene, {asked}, {digits, Rounding::nearest, false}).value(asked);
    CHECK(value.proved);
    return value.value;
}

scene::AskedValue pressure_of_curved(const std::string& u) {
    scene::AskedValue asked{scene::Quantity::p};
    asked.u = Exact::parse(u);
    return asked;
}

std::string refusal_of_curved(const auto& f) {
    try {
        f();
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

/// p, P, delta and c_0 of a scene against integrals of g' in Real.
void check_curved_body(const scene::Scene& scene, const std::vector<std::string>& places) {
    const Ball radius = value_of_curved(scene, {scene::Quantity::a}, digits_of_curved + 90);
    const PrecisionScope scope(digits_of_curved + 90);
    const AbelQuadrature second(scene, at_working_precision(radius.midpoint()),
                                digits_of_curved + 10);
    const auto check = [](const Real& x, const Ball& exact) {
        CHECK(digits_right(x, exact) + 1 >= digits_of_curved);
        CHECK(digits_proved(exact) + 1 >= digits_of_curved);
    };
    check(second.force(), value_of_curved(scene, {scene::Quantity::P}));
    check(second.approach(), value_of_curved(scene, {scene::Quantity::delta}));
    for (const std::string& u : places) {
        CAPTURE(u);
        check(second.pressure(Exact::parse(u).to<Real>()),
              value_of_curved(scene, pressure_of_curved(u)));
    }
}

} // namespace

TEST_CASE("the pressure at the middle of a flat with curved flanks under a given force") {
    const scene::Scene scene = curved_body("\"1/2\"", "\"0\", \"sinh(x - 1/2)\"", "P = \"1\"",
                                           "[ask]\nx = [\"0\", \"1e-3\"]\n");
    const Ball radius = value_of_curved(scene, {scene::Quantity::a}, digits_of_curved + 90);
    const PrecisionScope scope(digits_of_curved + 90);
    const Real a = at_working_precision(radius.midpoint());
    const AbelQuadrature second(scene, a, digits_of_curved + 10);
    const scene::SceneResult result = run_scene(scene);
    for (const std::size_t i : {0U, 1U}) {
        const scene::BoundedValue p = result.points().at(i).at(scene::Quantity::p);
        const Real x = i == 0 ? Real(0) : Real("1e-3");
        CHECK(p.proved);
        CHECK(digits_right(second.pressure(Real(a - x)), p.value) + 1 >= digits_of_curved);
        CHECK(digits_proved(p.value) + 1 >= digits_of_curved);
    }
}

// The pressure is linear in g' at a given radius, so that the polynomial is a sum of power laws.
TEST_CASE("a body of revolution of a polynomial slope is the sum of power laws") {
    const scene::Scene sum = curved_body("", "\"x/2 + x^3\"", "a = \"6/5\"");
    const auto power = [](const char* m, const char* C) {
        return scene::parse_scene(
            std::string("[profile]\ngeometry = \"axisymmetric\"\nkind = \"power-law\"\nm = \"") +
                m + "\"\nC = \"" + C + "\"\n[load]\na = \"6/5\"\ncontact_modulus = \"7/3\"\n",
            "power.toml");
    };
    const scene::Scene first = power("1", "1/2");
    const scene::Scene third = power("3", "1");
    scene::AskedValue c_2{scene::Quantity::c};
    c_2.k = 2;
    for (const scene::AskedValue& asked :
         {pressure_of_curved("1e-20"), pressure_of_curved("1/3"), pressure_of_curved("6/5"),
          scene::AskedValue{scene::Quantity::P}, scene::AskedValue{scene::Quantity::delta},
          scene::AskedValue{scene::Quantity::c}, c_2}) {
        const Ball whole = value_of_curved(sum, asked);
        CHECK(overlaps(whole, value_of_curved(first, asked) + value_of_curved(third, asked)));
        CHECK(digits_proved(whole) >= digits_of_curved);
    }
}

// sneddon1965: delta = (a/2) log((R + a)/(R - a)), and P = E* ((a^2 + R^2)/2 log((R + a)/(R - a))
// - a R) for an exact sphere.
TEST_CASE("an exact sphere of revolution") {
    const scene::Scene sphere = curved_body("", "\"x/sqrt(4 - x^2)\"", "a = \"3/2\"");
    const long bits = 300;
    const Ball ratio = log(Ball(7, bits));
    CHECK(overlaps(value_of_curved(sphere, {scene::Quantity::delta}), ratio * 3 / 4));
    const Ball P = (ratio * Ball(Rational(25, 8), bits) - 3) * 7 / 3;
    CHECK(overlaps(value_of_curved(sphere, {scene::Quantity::P}), P));
    const PrecisionScope scope(60);
    const scene::Scene by_force =
        curved_body("", "\"x/sqrt(4 - x^2)\"", "P = \"" + P.midpoint().str(60) + "\"");
    const Ball a = value_of_curved(by_force, {scene::Quantity::a});
    CHECK(digits_right(Real(Real(3) / 2), a) + 1 >= digits_of_curved);
}

namespace {

scene::AskedValue at_radius(scene::Quantity quantity, const std::string& x) {
    scene::AskedValue asked{quantity};
    asked.place =
        scene::Place::parse(x, scene::Place::From::origin, {}).distance(contact::Edge::right);
    return asked;
}

/// log((2 + s)/(2 - s)), of an exact sphere of the radius 2.
Real sphere_log(const Real& s) { return log(Real((2 + s) / (2 - s))); }
Real sphere_force(const Real& s) { return Real(7) / 3 * ((s * s + 4) / 2 * sphere_log(s) - 2 * s); }

} // namespace

// The surface is lifted by (2/pi) integral of h'(s) arcsin(s/r) ds over 0 < s < a (sneddon1965): an
// integral over the contact, where the program integrates over the gap. By parts.
TEST_CASE("the gap around curved bodies of revolution by the lifted surface") {
    const PrecisionScope scope(digits_of_curved + 20);
    const auto gap = [](const Real& a, const Real& r, const Real& height, const Real& delta,
                        const auto& h) {
        const auto lifted = quadrature::tanh_sinh<Real>([&](const Real& lo, const Real&) {
            const Real s = a * lo;
            return Real(h(s) / sqrt(Real(r * r - s * s)));
        });
        return Real(height - delta +
                    2 / pi<Real>() * (delta * asin(Real(a / r)) - a * lifted.value));
    };
    const auto check = [](const Real& expected, const scene::Scene& scene, const std::string& x) {
        const Ball found = value_of_curved(scene, at_radius(scene::Quantity::gap, x), 30);
        CHECK(digits_right(expected, found) >= 30);
        CHECK(digits_proved(found) >= 30);
    };
    const auto sphere = [](const Real& s) { return Real(s / 2 * sphere_log(s)); };
    const Real a = Real(3) / 2;
    const Real r = Real(19) / 10;
    check(gap(a, r, Real(2 - sqrt(Real(4 - r * r))), sphere(a), sphere),
          curved_body("", "\"x/sqrt(4 - x^2)\"", "a = \"3/2\""), "19/10");
    // A knot outside the contact, between the edge and the place, and at the place itself
    const Real inner = Real(1) / 4;
    const auto parabola = [](const Real& s) { return Real(s * s); };
    const auto beyond = [](const Real& x) { return Real((x - Real(3) / 2) * exp(x)); };
    const scene::Scene bent =
        curved_body("\"1/2\"", "\"x\", \"1 + (x - 1/2)*exp(x)\"", "a = \"1/4\"");
    const Real half = Real(1) / 2;
    const Real place = Real(3) / 4;
    check(gap(inner, place, Real(Real(1) / 8 + (place - half) + beyond(place) - beyond(half)),
              Real(inner * inner), parabola),
          bent, "3/4");
    check(gap(inner, half, Real(Real(1) / 8), Real(inner * inner), parabola), bent, "1/2");
}

// q = f (p - p*), and the area of the loop, by the closed forms of P and delta of an exact sphere.
TEST_CASE("partial slip of an exact sphere of revolution" * doctest::test_suite("slow")) {
    const scene::Scene sphere = curved_body("", "\"x/sqrt(4 - x^2)\"", "a = \"3/2\"\nnu = \"1/3\"",
                                            "[shear]\nQ = \"1\"\nfriction = \"1/2\"\n");
    const Ball stick = value_of_curved(sphere, {scene::Quantity::stick_a});
    const PrecisionScope scope(digits_of_curved + 20);
    const Real a = Real(3) / 2;
    const Real c = at_working_precision(stick.midpoint());
    CHECK(digits_right(Real(sphere_force(a) - 2), Ball(sphere_force(c), 200)) + 2 >=
          digits_of_curved);
    const AbelQuadrature whole(sphere, a, digits_of_curved);
    const AbelQuadrature inner(sphere, c, digits_of_curved);
    const Real u = Real(3) / 2 - Real(2) / 5;
    const Real q = (whole.pressure(u) - inner.pressure(Real(c - Real(2) / 5))) / 2;
    scene::AskedValue asked{scene::Quantity::q};
    asked.u = Exact::parse("11/10");
    CHECK(digits_right(q, value_of_curved(sphere, asked, 30)) >= 30);
    // On the axis the radius of the stick zone is not exact.
    asked.u = Exact::parse("3/2");
    CHECK(digits_right(Real((whole.pressure(a) - inner.pressure(c)) / 2),
                       value_of_curved(sphere, asked, 30)) >= 30);
    const Real mean = sphere_force(a) - 1;
    const auto area = quadrature::tanh_sinh<Real>([&](const Real& lo, const Real&) {
        const Real s = c + (a - c) * lo;
        const Real h_rate = sphere_log(s) / 2 + 2 * s / (4 - s * s);
        return Real((mean - sphere_force(s)) * h_rate);
    });
    const Real tangential = Real(5) / 4; // E*/E_t = (2 - nu)/(2 (1 - nu))
    CHECK(digits_right(Real(2 * tangential * (a - c) * area.value),
                       value_of_curved(sphere, {scene::Quantity::cycle_energy}, 30)) >= 29);
    const Ball slip =
        value_of_curved(sphere, at_radius(scene::Quantity::slip_displacement, "1.4"), 20);
    const scene::Scene corrective =
        curved_body("", "\"x/sqrt(4 - x^2)\"", "a = \"" + c.str(60) + "\"");
    const Ball gap = value_of_curved(corrective, at_radius(scene::Quantity::gap, "1.4"), 30);
    CHECK(digits_right(Real(-at_working_precision(gap.midpoint()) * tangential / 2), slip) >= 19);
}

TEST_CASE("curved bodies of revolution agree with integrals of g'" * doctest::test_suite("slow")) {
    check_curved_body(curved_body("", "\"sinh(x)\"", "P = \"1\""), {"1e-30", "1/7", "1/2"});
    // a rounded cone whose flank is curved, a corner, and an edge 1e-12 beyond it
    check_curved_body(curved_body("\"1/2\"", "\"x\", \"1/2 + (x - 1/2)*exp(x)\"", "delta = \"1\""),
                      {"1e-30", "1/5"});
    check_curved_body(
        curved_body("\"1/3\"", "\"x^2\", \"1/4 + log(1 + x)\"", "a = \"1/3 + 1e-12\""),
        {"1e-30", "1/5"});
}

TEST_CASE("the curved bodies of the reference table agree with integrals of g'" *
          doctest::test_suite("slow")) {
    const std::string file = test::source_dir() / "reference" / "axisymmetric.csv";
    const io::Csv table = io::parse_csv(io::read_text(file, "reference table"), file);
    const auto cell = [&](const io::Csv::Row& row, const char* name) {
        return row.cells.at(table.column(name).value());
    };
    std::size_t rows = 0;
    std::optional<AbelQuadrature> second;
    std::string of; // the scene of `second`
    const PrecisionScope scope(150);
    for (const io::Csv::Row& row : table.rows) {
        const std::string quantity = cell(row, "quantity");
        const bool computed = quantity == "p" || quantity == "P" || quantity == "delta";
        if (!cell(row, "id").starts_with("curved-") || !cell(row, "Q").empty() || !computed) {
            continue;
        }
        CAPTURE(cell(row, "id"));
        std::string slopes = "\"" + cell(row, "slopes") + "\"";
        if (const auto semicolon = slopes.find("; "); semicolon != std::string::npos) {
            slopes.replace(semicolon, 2, "\", \"");
        }
        const std::string knots =
            cell(row, "knots").empty() ? "" : "\"" + cell(row, "knots") + "\"";
        const bool by_force = cell(row, "a").empty();
        const std::string load = (by_force ? "P = \"" : "a = \"") +
                                 cell(row, by_force ? "P" : "a") + "\"\ncontact_modulus = \"1\"";
        if (of != slopes + load) {
            of = slopes + load;
            const scene::Scene scene = scene::parse_scene(
                "[profile]\ngeometry = \"axisymmetric\"\nkind = \"piecewise\"\n"
                "symmetric = true\nknots = [" +
                    knots + "]\nslopes = [" + slopes + "]\n[load]\n" + load + "\n",
                "row.toml");
            second.emplace(
                scene,
                at_working_precision(value_of_curved(scene, {scene::Quantity::a}, 145).midpoint()),
                60);
        }
        const Real value = quantity == "p"
                               ? second->pressure(Exact::parse(cell(row, "u")).to<Real>())
                           : quantity == "P" ? second->force()
                                             : second->approach();
        CHECK(digits_right(value, Ball(Real(cell(row, "value")), 500)) >= 49);
        ++rows;
    }
    CHECK(rows == 18);
}

TEST_CASE("the coefficients of a curved body of revolution agree with divided differences" *
          doctest::test_suite("slow")) {
    const scene::Scene scene =
        curved_body("\"1/2\"", "\"x\", \"1/2 + (x - 1/2)*exp(x)\"", "a = \"1\"");
    const unsigned digits = difference_digits(1, digits_of_curved);
    const PrecisionScope scope(digits + 70);
    const AbelQuadrature second(scene, Real(1), digits);
    scene::AskedValue c_1{scene::Quantity::c};
    c_1.k = 1;
    const Real differences = coefficient_by_differences(
        1, digits_of_curved, Real(Real(1) / 2), [&](const Real& u) { return second.pressure(u); });
    CHECK(digits_right(differences, value_of_curved(scene, c_1)) + 1 >= digits_of_curved);
}

TEST_CASE("what is not computed for curved bodies of revolution is refused") {
    const char* const slope = "\"sinh(x)\"";
    const char* const load = "a = \"1\"";
    const auto refused = [&](const std::string& rest) {
        return refusal_of_curved([&] { (void)run_scene(curved_body("", slope, load, rest)); });
    };
    CHECK(refused("[ask]\nterms = 2\nu = [\"0.1\"]\ndigits = 10\n").empty());
    CHECK(refused("[ask]\nx = [\"20\"]\nquantities = [\"displacement\"]\n").empty());
    CHECK(refusal_of_curved([&] {
              (void)run_scene(curved_body("\"2\"", "\"x\", \"sin(x - 2) + 2\"", load,
                                          "[ask]\nx = [\"4\"]\nquantities = [\"displacement\"]\n"));
          }).find("not proved not to decrease up to the place") != std::string::npos);
    CHECK(refused("[shear]\nQ = \"0.1\"\nfriction = \"1/2\"\n[ask]\nterms = 1\ntolerance = \"1%\"\n"
                  "quantities = [\"slip\"]\n")
              .find("leave tolerance out") != std::string::npos);
    for (const char* group : {"extent", "peak", "stress"}) {
        CAPTURE(group);
        CHECK(refused("[ask]\nterms = 1\ntolerance = \"1%\"\nx = [\"2\"]\n"
                      "quantities = [\"" +
                      std::string(group) + "\"]\n")
                  .find("curved slopes of revolution") != std::string::npos);
    }
    CHECK(refusal_of_curved([&] {
              (void)curved_body("\"1/2\"", "\"0\", \"sqrt(x - 1/2)\"", load);
          }).find("not analytic at r = 1/2") != std::string::npos);
    CHECK(refusal_of_curved([&] {
              (void)curved_body("", "\"x^(3/2)\"", load);
          }).find("not analytic at r = 0") != std::string::npos);
    CHECK(refusal_of_curved([&] {
              (void)curved_body("", "\"x + abs(x)\"", load);
          }).find("write it as pieces") != std::string::npos);
    CHECK(refusal_of_curved([&] {
              (void)run_scene(curved_body("", "\"sin(3*x)\"", load, "[ask]\nu = [\"0.1\"]\n"));
          }).find("decreases") != std::string::npos);
}
