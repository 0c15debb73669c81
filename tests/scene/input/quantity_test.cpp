// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/scene/scene_text.hpp"

#include "edgeproof/precision/error.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <map>
#include <set>

using namespace edgeproof::scenes;

namespace {

using Index = QuantityRow::Index;

const Digits thirty{30, Rounding::nearest, false};

/// Returns the contact with g' = x, a = 1, E* = 1, Q = 3/10, with lengths and moduli multiplied by
/// the arguments.
Scene sheared_hertz(const std::string& length = "1", const std::string& modulus = "1",
                    const std::string& more = "") {
    const std::string force = modulus + "*" + length;
    return parsed("[profile]\nkind = \"power-law\"\nm = \"1\"\nC = \"1/" + length +
                  "\"\n[load]\na = \"" + length + "\"\ncontact_modulus = \"" + modulus +
                  "\"\nnu = \"1/4\"\n[shear]\nQ = \"3/10*" + force + "\"\n" + more);
}

/// Adds friction, Q/(f P) = 3/4, so that half of each half slips.
Scene slipping_hertz_scene(const std::string& length = "1", const std::string& modulus = "1") {
    return sheared_hertz(length, modulus, "friction = \"8/(5*pi)\"\n");
}

/// The same contact, P first and then Q.
Scene stepped_hertz_scene(const std::string& length = "1", const std::string& modulus = "1") {
    const std::string force = modulus + "*" + length;
    return parsed("[profile]\nkind = \"power-law\"\nm = \"1\"\nC = \"1/" + length +
                  "\"\n[load]\ncontact_modulus = \"" + modulus +
                  "\"\n[shear]\nfriction = \"8/(5*pi)\"\n[[step]]\nP = \"pi/4*" + force +
                  "\"\n[[step]]\nQ = \"3/10*" + force + "\"\n");
}

/// Returns a wedge under P and M, whose tilt is unknown; M = 0: upright.
Scene loaded_wedge(const std::string& M, const std::string& length = "1",
                   const std::string& modulus = "1") {
    const std::string force = modulus + "*" + length;
    return parsed("[profile]\nkind = \"tilted-wedge\"\nphi = \"1/10\"\n[load]\nP = \"1/10*" +
                  force + "\"\nM = \"" + M + "*" + force + "*" + length +
                  "\"\ncontact_modulus = \"" + modulus + "\"\n");
}

/// Returns a sphere with a = 1, R = 1, E* = 1.
Scene sphere_scene(const std::string& length = "1", const std::string& modulus = "1") {
    return parsed("[profile]\nkind = \"hertz\"\ngeometry = \"axisymmetric\"\nR = \"" + length +
                  "\"\n[load]\na = \"" + length + "\"\ncontact_modulus = \"" + modulus + "\"\n");
}

bool is_made_of_others(const QuantityRow& row) { return !row.searched && row.ball == nullptr; }

/// Returns a row's quantity at the right edge, u = 1/5, with a tolerance of 1% and k = 1 if it has
/// these; a stress at x = 0, z = 3/4, the gap at x = 5/4, the dissipation at x = 4/5, other values
/// of the surface at x = 1/5, relative to x = 0.
AskedValue asked_of(const QuantityRow& row, const std::string& length = "1") {
    AskedValue asked{row.quantity};
    asked.k = row.index == Index::none ? 0 : 1;
    if (row.at_point()) {
        asked.u = Exact::parse("1/5*" + length);
    }
    if (row.place == QuantityRow::Place::body) {
        asked.in_body = {Exact(), Exact::parse("3/4*" + length)};
    }
    if (row.place == QuantityRow::Place::surface) {
        const std::string x = row.quantity == Quantity::gap           ? "5/4*"
                              : row.quantity == Quantity::dissipation ? "4/5*"
                                                                      : "1/5*";
        const auto at = [&](const std::string& text) {
            return Place::parse(text, Place::From::origin, {}).distance(asked.edge);
        };
        asked.place = at(x + length);
        asked.reference = at("0");
        asked.in_body = scene::BodyPoint{};
    }
    if (row.tolerance) {
        asked.tolerance = parse_tolerance("1%");
    }
    return asked;
}

BoundedValue in_balls(const Scene& scene, const AskedValue& asked) {
    return SceneValues(scene, {asked}, thirty).value(asked);
}

} // namespace

TEST_CASE("each quantity that has a symbol is read by it and written with it") {
    std::size_t symbols = 0;
    for (const QuantityRow& row : quantity_rows()) {
        CAPTURE(row.name);
        CHECK(row_of(row.quantity).name == row.name);
        if (row.symbol.empty()) {
            continue;
        }
        ++symbols;
        const std::string symbol(row.symbol);
        const std::size_t least = row.index == Index::terms ? 1 : 0;
        for (const std::size_t k : {least, std::size_t{7}, std::size_t{399}}) {
            const std::string text =
                row.index == Index::none ? symbol : symbol + "_" + std::to_string(k);
            const auto read = quantity_named(text);
            REQUIRE(read);
            CHECK(read->quantity == row.quantity);
            CHECK(read->k == (row.index == Index::none ? 0 : k));
            CHECK(symbol_of({read->quantity, read->k}) == text);
        }
        if (row.index != Index::none) {
            CHECK(family_of({row.quantity, 3}) == symbol + "_k");
            for (const char* bad : {"", "_", "_400", "_-1", "_1x", "_ 1", "1"}) {
                CHECK_FALSE(quantity_named(symbol + bad));
            }
            CHECK(quantity_named(symbol + "_0").has_value() == (row.index == Index::order));
        }
    }
    CHECK(symbols == 26);
    CHECK_FALSE(quantity_named(""));
    CHECK_FALSE(quantity_named("heat"));
    CHECK_FALSE(quantity_named("p_1"));
}

TEST_CASE("each quantity is enclosed: Hertz and a wedge by hand") {
    // p = sqrt(u (2 - u))/2, q = Q/(pi sqrt(u (2 - u))): at u = 1/5 these are 3/10 and 1/(2 pi).
    // The ratio of one term to p is sqrt(2/(2 - u)): it is 1.01 at u = 2 - 2/1.0201 = 402/10201,
    // and more beyond.
    constexpr long bits = 200;
    const Ball pi = acos(Ball(-1, bits));
    const Ball fifth = pi / 2 - acos(Ball(Rational(1, 5), bits)); // arcsin(1/5)
    const Ball root = sqrt(Ball(2, bits));
    // On the axis of a cylinder, p_0 = 1/2, a = 1, z = 3/4 (johnson1985, eq. 4.46): sxx = -1/10,
    // szz = -2/5. There q gives sxz = -(Q/pi) (1 + z^2)^(-3/2) alone.
    const Ball sxz = Ball(Rational(-96, 625), bits) / pi;
    const std::map<Quantity, Ball> by_hand{
        {Quantity::p, Ball(Rational(3, 10), bits)},
        {Quantity::q, 1 / (2 * pi)},
        {Quantity::c, -root / 8},                // sqrt(2 - u)/2 = sqrt(2)/2 (1 - u/4 - ...)
        {Quantity::s, 3 / (10 * pi * root * 4)}, // 1/sqrt(2 - u) = (1 + u/4 + ...)/sqrt(2)
        {Quantity::a, Ball(1, bits)},
        {Quantity::b, Ball(1, bits)},
        {Quantity::P, pi / 4},
        {Quantity::M, Ball(0, bits)},
        {Quantity::alpha, Ball(0, bits)},
        {Quantity::extent, Ball(Rational(402, 10201), bits)},
        {Quantity::measure, Ball(Rational(402, 10201), bits)},
        {Quantity::slip, Ball(Rational(1, 2), bits)}, // 1 - sqrt(1 - 3/4)
        {Quantity::stick_a, Ball(Rational(1, 2), bits)},
        {Quantity::stick_b, Ball(Rational(1, 2), bits)},
        {Quantity::p_max, Ball(Rational(1, 2), bits)}, // sqrt(1 - x^2)/2 at x = 0
        // (8 f^2 P^2/(2 pi)) (t - t^2/2 + (1 - t) ln(1 - t)), f P = 2/5, t = 3/4
        {Quantity::cycle_energy,
         (Ball(Rational(15, 32), bits) - log(Ball(2, bits)) / 2) * 16 / (pi * 25)},
        {Quantity::x, Ball(Rational(4, 5), bits)},
        {Quantity::u, Ball(Rational(1, 5), bits)},
        {Quantity::local, 1 / sqrt(Ball(10, bits))}, // sqrt(2 u)/2
        {Quantity::rel, sqrt(Ball(10, bits)) / 3 - 1},
        {Quantity::q_local, 3 / (10 * pi) * sqrt(Ball(Rational(5, 2), bits))}, // Q/(pi sqrt(2 u))
        {Quantity::q_rel, 1 - 3 / sqrt(Ball(10, bits))},
        {Quantity::extent_fraction, Ball(Rational(201, 10201), bits)},
        {Quantity::measure_fraction, Ball(Rational(201, 10201), bits)},
        {Quantity::crossing, Ball(Rational(402, 10201), bits)},
        {Quantity::load_ratio, Ball(Rational(3, 4), bits)},
        // 2 f E* (a - 1/2)/R with f = 8/(5 pi)
        {Quantity::least_tension, -8 / (5 * pi)},
        {Quantity::most_tension, 8 / (5 * pi)},
        // d_1 = t/2; d_1/d = (1 + s)/2 with s = sqrt(1 - t), so that the error is 1% at s = 49/50.
        {Quantity::slip_terms, Ball(Rational(3, 8), bits)},
        {Quantity::slip_rel, Ball(Rational(1, 4), bits)},
        {Quantity::slip_load, Ball(Rational(99, 2500), bits)},
        {Quantity::sxx, Ball(Rational(-1, 10), bits)},
        {Quantity::szz, Ball(Rational(-2, 5), bits)},
        {Quantity::sxz, sxz},
        // syy = -1/8 with nu = 1/4: (3/10)^2 + (11/40)^2 + (1/40)^2 = 133/800
        {Quantity::mises, sqrt(Ball(Rational(133, 1600), bits) + sxz * sxz * 3)},
        {Quantity::tau_max, sqrt(Ball(Rational(9, 400), bits) + sxz * sxz)},
        {Quantity::syy, Ball(Rational(-1, 8), bits)},
        {Quantity::s1, sqrt(Ball(Rational(9, 400), bits) + sxz * sxz) - Ball(Rational(1, 4), bits)},
        {Quantity::s2, Ball(Rational(-1, 8), bits)},
        {Quantity::s3,
         -sqrt(Ball(Rational(9, 400), bits) + sxz * sxz) - Ball(Rational(1, 4), bits)},
        {Quantity::tresca, sqrt(Ball(Rational(9, 400), bits) + sxz * sxz) * 2},
        // Q moves the bodies by D(Q), from -Q to Q and back by 2 D(Q/2) each (johnson1985, sec.
        // 7.4): the loop has four times the energy of the first step.
        {Quantity::step_energy,
         (Ball(Rational(15, 32), bits) - log(Ball(2, bits)) / 2) * 4 / (pi * 25)},
        // (1/2) (x sqrt(x^2 - 1) - arcosh x) at x = 5/4 (johnson1985, sec. 5.4)
        {Quantity::gap, (Ball(Rational(15, 16), bits) - log(Ball(2, bits))) / 2},
        {Quantity::slip_displacement, Ball(0, bits)},
        {Quantity::delta, Ball(1, bits)},     // a^2/R of a sphere
        {Quantity::stiffness, Ball(2, bits)}, // dP/da = 4 E* a^2/R, d delta/da = 2 a/R
        // With nu = 1/4 and E* = 1 the compliances of docs/stress.md are (1 - nu^2)/E = 1/2 and
        // 1/3; the integral of p from 0 to x is (x sqrt(1 - x^2) + arcsin x)/4, that of q is (Q/pi)
        // arcsin x with Q = 3/10.
        {Quantity::ux, -(sqrt(Ball(24, bits)) / 25 + fifth) / 12},
        {Quantity::uz, fifth / (pi * 10) - Ball(Rational(1, 100), bits)},
        {Quantity::slope, 1 / (pi * sqrt(Ball(24, bits)) * 2) - Ball(Rational(1, 10), bits)},
        // 4 f^2 p h with p = 3/10 and the gap h of the stick zone, of the half width 1/2
        {Quantity::dissipation,
         Ball(Rational(192, 125), bits) / (pi * pi) *
             (sqrt(Ball(39, bits)) * 2 / 25 - log((Ball(8, bits) + sqrt(Ball(39, bits))) / 5) / 4)},
    };
    for (const QuantityRow& row : quantity_rows()) {
        CAPTURE(row.name);
        const Scene scene = row.needs == QuantityRow::Needs::unknown_tilt ? loaded_wedge("0")
                            : row.needs == QuantityRow::Needs::round      ? sphere_scene()
                            : row.needs == QuantityRow::Needs::history    ? stepped_hertz_scene()
                            : row.of_friction()                           ? slipping_hertz_scene()
                                                                          : sheared_hertz();
        const AskedValue asked = asked_of(row);
        if (is_made_of_others(row)) {
            CHECK_THROWS_AS((void)in_balls(scene, asked), Error);
            continue;
        }
        const Ball& exact = by_hand.at(row.quantity);
        const BoundedValue enclosed = in_balls(scene, asked);
        CHECK(enclosed.proved);
        CHECK(overlaps(enclosed.value, exact));
        CHECK(enclosed.value.radius() < Real(row.short_error ? "1e-20" : "1e-30"));
    }
}

TEST_CASE("the dimension of each quantity: lengths doubled, moduli three times as large") {
    for (const QuantityRow& row : quantity_rows()) {
        if (is_made_of_others(row)) {
            continue;
        }
        CAPTURE(row.name);
        const bool tilt = row.needs == QuantityRow::Needs::unknown_tilt;
        const AskedValue asked = asked_of(row);
        const bool slips = row.of_friction();
        const bool round = row.needs == QuantityRow::Needs::round;
        const bool steps = row.needs == QuantityRow::Needs::history;
        const Ball one = in_balls(tilt    ? loaded_wedge("1/100")
                                  : round ? sphere_scene()
                                  : steps ? stepped_hertz_scene()
                                  : slips ? slipping_hertz_scene()
                                          : sheared_hertz(),
                                  asked)
                             .value;
        const Ball other = in_balls(tilt    ? loaded_wedge("1/100", "2", "3")
                                    : round ? sphere_scene("2", "3")
                                    : steps ? stepped_hertz_scene("2", "3")
                                    : slips ? slipping_hertz_scene("2", "3")
                                            : sheared_hertz("2", "3"),
                                    asked_of(row, "2"))
                               .value;
        // A force per length is a modulus times a length.
        const double factor = scale_of(asked, 3 * 2, 2) / scale_of(asked, 1, 1);
        CHECK(other.midpoint().convert_to<double>() ==
              doctest::Approx(factor * one.midpoint().convert_to<double>()).epsilon(1e-12));
    }
    CHECK(scale_of({Quantity::c, 2}, 6, 4) == 6.0 / 128); // 6/4^(7/2)
    CHECK(scale_of({Quantity::alpha}, 6, 4) == 1);
}

TEST_CASE("a name that is not a quantity: how to write one, and which one was likely meant") {
    const std::string all =
        "write p, q, c_0, c_1, ..., s_0, s_1, ..., a, b, P, M, alpha, "
        "extent_1, measure_1, slip, stick_a, stick_b, p_max, cycle_energy, sxx, szz, sxz, "
        "mises, tau_max, syy, tresca, step_energy, delta or stiffness";
    CHECK(quantity_advice("temperature") == all);
    CHECK(quantity_advice("c1") == "did you mean c_1? " + all);
    CHECK(quantity_advice("alhpa") == "did you mean alpha? " + all);
    CHECK(quantity_advice("extend_2") == "did you mean extent_2? " + all);
    CHECK(quantity_advice("pressure") == "did you mean p? " + all);
    CHECK(quantity_advice("moment") == "did you mean M? " + all);
    try {
        (void)parsed(hertz("1", "quantities = [\"presure\"]\n"));
        FAIL("accepted");
    } catch (const InputError& error) {
        CHECK(error.instead() ==
              "did you mean pressure? write one of pressure, coefficients, "
              "shear, extent, slip, contact, peak, stress, displacement, surface");
    }
    for (const GroupRow& row : group_rows()) {
        const std::string asked = "u = \"1/2\"\nterms = 1\ntolerance = \"1%\"\nquantities = [\"" +
                                  std::string(row.name) + "\"]\nreference = 0\n";
        // The shear is small compared with friction, also for a small load.
        const std::string shear = row.friction ? "[shear]\nQ = \"1/1000\"\nfriction = \"1/2\"\n"
                                  : row.shear  ? "[shear]\nQ = \"1\"\n"
                                               : "nu = 0.3\n";
        const Scene scene = parsed(tilted_wedge(shear, asked));
        CHECK(scene.ask.quantities == std::set{row.group});
        CHECK(group_name(row.group) == row.name);
        CHECK_NOTHROW((void)make_plan(scene));
    }
}

TEST_CASE("a value in words") {
    const Exact u = Exact::parse("1e-40");
    CHECK(text_of({.quantity = Quantity::p, .u = u}) == "p at u = 1e-40 from the right edge");
    CHECK(text_of({Quantity::c, 1, Edge::left}) == "c_1 at the left edge");
    CHECK(text_of({Quantity::extent, 2}) == "extent of 2 terms at the right edge");
    CHECK(text_of({Quantity::residual, 20, Edge::left, u}) ==
          "residual of 20 terms at u = 1e-40 from the left edge");
    CHECK(text_of({.quantity = Quantity::tilt_difference, .u = u}) ==
          "p minus p without tilt at u = 1e-40 from the right edge");
    CHECK(text_of({Quantity::b}) == "b");
    CHECK(edge_named("left") == Edge::left);
    CHECK_FALSE(edge_named("top"));
}

TEST_CASE("what a scene lacks for a quantity") {
    const Scene plain = parsed(hertz("1", "terms = 1\n"));
    CHECK_FALSE(lack_of(plain, {Quantity::p}));
    CHECK_FALSE(lack_of(sheared_hertz(), {Quantity::s, 2}));
    CHECK(lack_of(plain, {Quantity::s, 2})->problem == "s_2 is requested, but there is no shear");
    CHECK(lack_of(plain, {Quantity::s, 2})->instead == "add Q or bulk_tension, or leave s_2 out");
    CHECK(lack_of(plain, {Quantity::alpha})->problem ==
          "alpha is requested, but is not an unknown of the scene");
    CHECK_FALSE(lack_of(loaded_wedge("0"), {Quantity::alpha}));
    CHECK(lack_of(sheared_hertz(), {Quantity::slip})->problem ==
          "slip is requested, but there is no friction");
    CHECK_FALSE(lack_of(slipping_hertz_scene(), {Quantity::stick_a}));
}
