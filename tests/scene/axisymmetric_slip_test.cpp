// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/precision/error.hpp"
#include "edgeproof/quadrature/tanh_sinh.hpp"
#include "edgeproof/scene/scene.hpp"
#include "tests/support/namespaces.hpp"
#include "tests/support/paths.hpp"

#include <doctest/doctest.h>

#include <array>
#include <ios>
#include <string>
#include <utility>

namespace {

constexpr long stuck_bits = 300;

const std::string round_flat =
    "kind = \"flat-and-rounded\"\nt = \"2/5\"\nR = \"3\""; // a bend at r = 2/5

scene::Scene pushed(const std::string& profile, const std::string& load, const std::string& rest) {
    return scene::parse_scene("[profile]\ngeometry = \"axisymmetric\"\n" + profile + "\n[load]\n" +
                                  load + "\n" + rest,
                              "pushed.toml");
}

Ball value_of_pushed(const scene::Scene& s, scene::Quantity quantity) {
    const scene::BoundedValue value =
        scene::SceneValues(s, {{quantity}}, {30, Rounding::nearest, false}).value({quantity});
    CHECK(value.proved);
    return value.value;
}

Real number_of_pushed(const scene::Scene& s, scene::Quantity quantity) {
    return at_working_precision(value_of_pushed(s, quantity).midpoint());
}

std::string decimal(const Real& x) { return x.str(45, std::ios_base::scientific); }

std::string pushed_refusal(const std::string& rest) {
    try {
        (void)run_scene(pushed("kind = \"hertz\"\nR = \"1\"", "contact_modulus = \"1\"",
                               rest + "\n[ask]\nu = [\"1/10\"]\n"));
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

} // namespace

// The header of the example cattaneo.inp of CONTACT states 7/8 of the force of sliding and a stick
// zone of half the radius.
TEST_CASE("the stick zone of a ball in an example of CONTACT") {
    const scene::Scene ball =
        scene::read_scene(test::source_dir() / "examples" / "scenes" / "cattaneo.toml");
    CHECK(overlaps(value_of_pushed(ball, scene::Quantity::stick_a), Ball(1, stuck_bits) / 2));
    CHECK(overlaps(value_of_pushed(ball, scene::Quantity::P) * Ball(Rational(7, 20), stuck_bits),
                   formula::ball_of(ball.shear->Q, stuck_bits)));
}

// dP/d delta is the ratio of the differences of P and delta between two radii, up to the distance
// of these.
TEST_CASE("the contact stiffness of bodies of revolution") {
    const PrecisionScope precision(60);
    for (const std::string& profile :
         {round_flat, std::string("kind = \"power-law\"\nm = \"5/2\"\nC = \"3/7\""),
          std::string("kind = \"piecewise\"\nsymmetric = true\nknots = [\"1/3\"]\n"
                      "slopes = [\"1/8\", \"1/4 + x\"]")}) {
        CAPTURE(profile);
        const auto at = [&](const char* a) {
            return pushed(profile, std::string("a = \"") + a + "\"\ncontact_modulus = \"7/3\"", "");
        };
        const scene::Scene near = at("9/10");
        const scene::Scene far = at("9/10 + 1e-12");
        const auto grown = [&](scene::Quantity quantity) {
            return Real(number_of_pushed(far, quantity) - number_of_pushed(near, quantity));
        };
        const Real ratio = grown(scene::Quantity::P) / grown(scene::Quantity::delta);
        const Real found = number_of_pushed(near, scene::Quantity::stiffness);
        CHECK(abs(Real(ratio / found - 1)) < Real("1e-11"));
    }
}

// johnson1985, section 7.4 (Mindlin, Deresiewicz): with s = 1 - Q/(f P),
// W = (9 f^2 P^2/(10 a)) [(2 - nu_1)/G_1 + (2 - nu_2)/G_2] (1 - s^(5/3) - (5/6)(1 - s)(1 +
// s^(2/3))).
TEST_CASE("the energy of a cycle of a sphere") {
    const Ball left = Ball(Rational(2, 5), stuck_bits);
    const Ball third = pow(left, Rational(1, 3));
    const Ball expected_factor =
        1 - left * third * third - (1 - left) * (1 + third * third) * 5 / 6;
    const std::string shear = "[shear]\nQ = \"3/10\"\nfriction = \"1/2\"\n"; // Q/(f P) = 3/5
    // Both bodies alike: E* = E/(2 (1 - nu^2)) = 8, G = E/(2 (1 + nu)) = 6.
    const scene::Scene alike =
        pushed("kind = \"hertz\"\nR = \"4\"",
               "P = \"1\"\nE1 = \"15\"\nnu1 = \"1/4\"\nE2 = \"15\"\nnu2 = \"1/4\"", shear);
    const Ball a = pow(Ball(Rational(3, 8), stuck_bits), Rational(1, 3)); // 3 P R/(4 E*)
    const Ball W = expected_factor * 9 / (a * 40) * 7 / 12;
    CHECK(overlaps(value_of_pushed(alike, scene::Quantity::cycle_energy), W));
    const scene::Scene by_nu = pushed("kind = \"hertz\"\nR = \"4\"",
                                      "P = \"1\"\ncontact_modulus = \"8\"\nnu = \"1/4\"", shear);
    CHECK(overlaps(value_of_pushed(by_nu, scene::Quantity::cycle_energy), W));
    CHECK(value_of_pushed(by_nu, scene::Quantity::cycle_energy).relative_accuracy_bits() > 90);
}

// A step dQ moves a stick zone of radius c by dQ/(2 E_t c) (johnson1985, section 7.2), so that the
// loop has the area 4 (f^2/E_t) times the integral of (P - Q/(2 f) - L)/c(L) over P - Q/f < L < P.
TEST_CASE("the energy of a cycle of a flat and rounded punch" * doctest::test_suite("slow")) {
    const PrecisionScope precision(40);
    const std::string material = "\ncontact_modulus = \"7/3\"\nnu = \"3/10\"";
    const Real tangential = Real(7) / 3 * 14 / 17; // E* 2 (1 - nu)/(2 - nu)
    for (const char* profile :
         {round_flat.c_str(), "kind = \"piecewise\"\nsymmetric = true\nknots = [\"1/3\"]\n"
                              "slopes = [\"1/8\", \"1/4 + x\"]"}) {
        CAPTURE(std::string(profile));
        const scene::Scene s =
            pushed(profile, "P = \"1/2\"" + material, "[shear]\nQ = \"1/5\"\nfriction = \"1/2\"\n");
        const Real P = Real(1) / 2;
        const Real range = Real(2) / 5;
        const Real area =
            quadrature::tanh_sinh<Real>(
                [&](const Real& lo, const Real&) {
                    const Real L = P - range + range * lo;
                    const scene::Scene inner =
                        pushed(profile, "P = \"" + decimal(L) + "\"" + material, "");
                    return Real((P - range / 2 - L) / number_of_pushed(inner, scene::Quantity::a));
                },
                {.target_digits = 12})
                .value *
            range;
        const Real W = number_of_pushed(s, scene::Quantity::cycle_energy);
        CHECK(abs(Real(area / tangential - W)) < W * Real("1e-9")); // 4 f^2 = 1
    }
}

// c/a = s = (1 - Q/(f P))^(1/3) of a sphere: with tau = 1 - s^3, d_1/d = (1 + s + s^2)/3, and d_2 =
// a (tau/3 + tau^2/9).
TEST_CASE("the slip zone of a sphere by its first terms") {
    const scene::SceneResult result = run_scene(
        pushed("kind = \"hertz\"\nR = \"1\"", "a = \"1\"\ncontact_modulus = \"3/4\"", // P = 1
               "[shear]\nQ = \"19/54\"\nfriction = \"1/2\"\n" // tau = 19/27, s = 2/3
               "[ask]\nterms = [1, 2]\ntolerance = \"10%\"\nquantities = [\"slip\"]\n"
               "edges = [\"right\"]\n"));
    const scene::RowsAt at = result.at_edges(scene::QuantityGroup::slip).at(0);
    const Rational tau(19, 27);
    CHECK(contains(at.at(scene::Quantity::slip).value, Rational(1, 3)));
    CHECK(contains(at.at(scene::Quantity::slip_terms, 1).value, Rational(tau / 3)));
    CHECK(contains(at.at(scene::Quantity::slip_terms, 2).value, Rational(tau / 3 + tau * tau / 9)));
    // 1 + s + s^2 = 27/10
    const Ball s = (sqrt(Ball(Rational(39, 5), stuck_bits)) - 1) / 2;
    CHECK(overlaps(at.row(scene::Quantity::slip_load, 1).value->value, 1 - s * s * s));
}

TEST_CASE("the slip zone of a flat and rounded punch by its first terms") {
    const PrecisionScope precision(60);
    const auto error = [&](const char* Q, std::size_t n) {
        const scene::SceneResult result = run_scene(
            pushed(round_flat, "a = \"1\"\ncontact_modulus = \"1\"",
                   std::string("[shear]\nQ = \"") + Q + "\"\nfriction = \"1/2\"\n" +
                       "[ask]\nterms = [1, 3]\nquantities = [\"slip\"]\nedges = [\"right\"]\n"
                       "digits = 30\n"));
        return at_working_precision(result.at_edges(scene::QuantityGroup::slip)
                                        .at(0)
                                        .at(scene::Quantity::slip_rel, n)
                                        .value.midpoint());
    };
    for (const std::size_t n : {1U, 3U}) {
        CHECK(abs(Real(log10(Real(error("1e-4", n) / error("1e-7", n))) / 3 - n)) < Real("0.01"));
    }
}

TEST_CASE("bulk stresses of axisymmetric contacts are refused, also in steps") {
    const char* const refused = "of the shear of axisymmetric contacts only partial slip";
    CHECK(pushed_refusal("[shear]\nfriction = \"1/2\"\n[[step]]\nP = \"1\"\n[[step]]\nQ = "
                         "\"1/10\"\nbulk_tension = \"1/10\"")
              .find(refused) != std::string::npos);
    CHECK(pushed_refusal("[shear]\nfriction = \"1/2\"\nbulk_A = \"1\"\n[[step]]\nP = "
                         "\"1\"\n[[step]]\nQ = \"1/10\"")
              .find(refused) != std::string::npos);
    CHECK(pushed_refusal("[shear]\nfriction = \"1/2\"\n[[step]]\nP = \"1\"\n[[step]]\nQ = "
                         "\"1/10\"")
              .empty());
    try {
        (void)pushed("kind = \"hertz\"\nR = \"1\"", "P = \"1\"\ncontact_modulus = \"1\"",
                     "[shear]\nQ = \"1/10\"\nfriction = \"1/2\"\nbulk_A = \"1\"\n");
        FAIL("bulk_A is not refused");
    } catch (const InputError& error) {
        CHECK(std::string(error.what()).find(refused) != std::string::npos);
    }
}

// The contact lies inside the first bend, so that it is that of a sphere (johnson1985, eq. 3.42a):
// u_z = (1/(pi R))[(2 a^2 - r^2) arcsin(a/r) + a sqrt(r^2 - a^2)] outside it.
TEST_CASE("the gap beyond a bend that lies outside the contact") {
    const scene::SceneResult result = run_scene(
        pushed("kind = \"piecewise\"\nsymmetric = true\nknots = [\"1/2\"]\nslopes = [\"x\", "
               "\"1/2\"]",
               "a = \"1/4\"\ncontact_modulus = \"7/3\"",
               "[ask]\nx = [\"1/2\", \"3/4\", \"-2\"]\nquantities = [\"displacement\"]\n"));
    std::size_t found = 0;
    for (const scene::Row& row : result.rows) {
        if (row.asked.quantity != scene::Quantity::gap || !row.value) {
            continue;
        }
        const Rational r = std::array{Rational(1, 2), Rational(3, 4), Rational(2)}.at(found++);
        const Rational a(1, 4);
        const Ball lifted = (Ball(Rational(2 * a * a - r * r), stuck_bits) *
                                 asin(Ball(Rational(a / r), stuck_bits)) +
                             sqrt(Ball(Rational(r * r - a * a), stuck_bits)) / 4) /
                            Ball::pi(stuck_bits);
        const Ball gap = lifted + Ball(Rational(r / 2 - Rational(1, 8) - a * a), stuck_bits);
        CHECK(row.value->proved);
        CHECK(overlaps(row.value->value, gap));
        CHECK(row.value->value.relative_accuracy_bits() > 160);
    }
    CHECK(found == 3);
}

// p is infinite at the corner of a truncated cone; one term leaves the tolerance before it.
TEST_CASE("the extent of one term of a truncated cone" * doctest::test_suite("slow")) {
    const std::string profile =
        "kind = \"piecewise\"\nsymmetric = true\nknots = [\"1/3\"]\nslopes = [\"0\", \"1/4\"]";
    const std::string load = "a = \"1\"\ncontact_modulus = \"1\"";
    const scene::SceneResult found = run_scene(
        pushed(profile, load,
               "[ask]\nterms = 1\ntolerance = \"10%\"\nquantities = [\"extent\"]\ndigits = 20\n"
               "edges = [\"right\"]\n"));
    const scene::Row* extent =
        found.at_edges(scene::QuantityGroup::extent).at(0).find(scene::Quantity::extent, 1);
    REQUIRE(extent != nullptr);
    CHECK(extent->value->proved);
    const PrecisionScope precision(40);
    const Real u = at_working_precision(extent->value->value.midpoint());
    for (const auto& [factor, within] :
         {std::pair{"0.999999", true}, std::pair{"1.000001", false}}) {
        const scene::SceneResult at =
            run_scene(pushed(profile, load,
                             "[ask]\nterms = 1\nu = [\"" + decimal(Real(u * Real(factor))) +
                                 "\"]\nedges = [\"right\"]\n"));
        CHECK((at.points()[0].at(scene::Quantity::rel, 1).value.midpoint() < Real("0.1")) ==
              within);
    }
}
