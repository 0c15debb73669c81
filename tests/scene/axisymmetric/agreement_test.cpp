// SPDX-License-Identifier: GPL-3.0-or-later
// Axisymmetric contacts drawn from a fixed seed: every value agrees to 50 digits with integrals
// that share no formula with it, and Boussinesq's integral of the pressure returns the profile.

#include "edgeproof/precision/rounding/text.hpp"
#include "edgeproof/quadrature/tanh_sinh.hpp"
#include "edgeproof/scene/scene.hpp"
#include "tests/scene/axisymmetric/abel_quadrature.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <ios>
#include <map>
#include <random>
#include <string>
#include <vector>

namespace {

constexpr unsigned agreed_digits = 50;

struct DrawnBody {
    std::string scene;              ///< [profile] and [load]
    std::vector<std::string> knots; ///< radii of the bends
};

class BodyDraw {
public:
    explicit BodyDraw(std::uint64_t seed) : draw_(seed) {}
    long whole(long from, long to) {
        return from + static_cast<long>(draw_() % static_cast<std::uint64_t>(to - from + 1));
    }
    std::string fraction(long most) { // in (0, most]
        const long below = whole(5, 97);
        return std::to_string(whole(1, below * most)) + "/" + std::to_string(below);
    }
    /// A decimal with `digits` random digits between 0 and 1.
    std::string decimal(int digits) {
        std::string text = "0.";
        for (int i = 0; i < digits; ++i) {
            text += static_cast<char>('0' + whole(i == 0 ? 1 : 0, 9));
        }
        return text;
    }
    DrawnBody body(long number) {
        const long turn = number / 6;
        DrawnBody b;
        std::string profile = "geometry = \"axisymmetric\"\n";
        const std::string slope = fraction(1);
        const std::string v = fraction(2);
        const auto piecewise = [&](const std::string& slopes) {
            std::string knots;
            for (const std::string& knot : b.knots) {
                knots += (knots.empty() ? "\"" : ", \"") + knot + "\"";
            }
            profile += "kind = \"piecewise\"\nsymmetric = true\nknots = [" + knots +
                       "]\nslopes = [" + slopes + "]\n";
        };
        switch (number % 6) {
        case 0: // a power law
            profile +=
                "kind = \"power-law\"\nC = \"" + fraction(2) + "\"\nm = \"" + fraction(6) + "\"\n";
            break;
        case 1: // a cone or a sphere
            profile += "kind = \"power-law\"\nC = \"" + slope + "\"\nm = \"" +
                       (turn % 2 == 0 ? "0" : "1") + "\"\n";
            break;
        case 2:
            b.knots = {v};
            profile +=
                "kind = \"flat-and-rounded\"\nt = \"" + v + "\"\nR = \"" + fraction(20) + "\"\n";
            break;
        case 3: // a cone with a rounded tip
            b.knots = {v};
            piecewise("\"" + slope + "*x\", \"" + slope + "*(" + v + ")\"");
            break;
        case 4: // a truncated cone
            b.knots = {v};
            piecewise("\"0\", \"" + slope + "\"");
            break;
        default: // an apex, a corner and a change of the rate
            b.knots = {v, "(" + v + ") + " + fraction(1)};
            piecewise("\"" + slope + "\", \"2*(" + slope + ") + x/5\", \"2*(" + slope + ") + (" +
                      b.knots[1] + ")/5 + (x - (" + b.knots[1] + "))/3\"");
        }
        std::string load;
        if (turn % 4 == 3 && !b.knots.empty()) {
            load = "a = \"(" + b.knots.back() + ") + 1e-12\"\n";
        } else {
            const char* const key = turn % 3 == 0 ? "a" : turn % 3 == 1 ? "P" : "delta";
            load = key == std::string("a") && !b.knots.empty()
                       ? "a = \"(" + b.knots.back() + ") + " + fraction(1) + "\"\n"
                       : std::string(key) + " = \"" + fraction(3) + "\"\n";
        }
        b.scene = "[profile]\n" + profile + "[load]\n" + load + "contact_modulus = \"" +
                  fraction(9) + "\"\n";
        return b;
    }

private:
    std::mt19937_64 draw_;
};

std::string decimals_of(const Real& x) { return x.str(40, std::ios_base::scientific); }

/// Distances from the edge (length) as exact decimals: 1e-30, near each bend inside, and drawn
/// ones.
std::vector<std::string> places_in_body(BodyDraw& draw, const DrawnBody& body, const Ball& radius,
                                        std::size_t count) {
    const PrecisionScope scope(60);
    const Real a = at_working_precision(radius.midpoint());
    std::vector<std::string> places{"1e-30"};
    for (const std::string& knot : body.knots) {
        const Real beyond = a - Exact::parse(knot).to<Real>();
        for (const char* apart : {"1e-10", "-1e-10"}) {
            const Real u = beyond + Real(apart);
            if (u > 0 && u < a) {
                places.push_back(decimals_of(u));
            }
        }
    }
    while (places.size() < count) {
        const Real x(draw.decimal(17));
        const long kind = draw.whole(0, 3);
        places.push_back(decimals_of(kind == 0 ? Real(a * x * pow(Real(10), -draw.whole(1, 20)))
                                     : kind == 1
                                         ? Real(a * (1 - x * pow(Real(10), -draw.whole(1, 8))))
                                         : Real(a * x)));
    }
    return places;
}

Ball value_in_body(scene::SceneValues& values, const scene::AskedValue& asked) {
    const scene::BoundedValue value = values.value(asked);
    CHECK(value.proved);
    return value.value;
}

void check_digits(const Real& second, const Ball& first) {
    CHECK(digits_right(second, first) + 1 >= agreed_digits);
    CHECK(digits_proved(first) + 1 >= agreed_digits);
}

/// Compares P, delta, and p at `places` places, of drawn contacts. h' is interpolated for many
/// places.
void compare_bodies(long contacts, std::size_t places) {
    BodyDraw draw(350);
    std::size_t compared = 0;
    for (long number = 0; number < contacts; ++number) {
        const DrawnBody body = draw.body(number);
        CAPTURE(body.scene);
        const scene::Scene scene = scene::parse_scene(body.scene, "drawn.toml");
        constexpr unsigned working = agreed_digits + 60;
        const scene::AskedValue radius{scene::Quantity::a};
        scene::SceneValues more(scene, {radius}, {working, Rounding::nearest, false});
        const Ball known = value_in_body(more, radius);
        const PrecisionScope scope(working + 10);
        AbelQuadrature second(scene, at_working_precision(known.midpoint()), agreed_digits + 5);
        if (places > 100) {
            second.tabulate();
        }
        scene::AskedValue asked{scene::Quantity::p};
        asked.u = Exact::parse("1e-30");
        scene::SceneValues values(scene, {asked, {scene::Quantity::P}, {scene::Quantity::delta}},
                                  {agreed_digits, Rounding::nearest, false});
        check_digits(second.force(), value_in_body(values, {scene::Quantity::P}));
        check_digits(second.approach(), value_in_body(values, {scene::Quantity::delta}));
        for (const std::string& u : places_in_body(draw, body, known, places)) {
            CAPTURE(u);
            asked.u = Exact::parse(u);
            check_digits(second.pressure(asked.u->to<Real>()), value_in_body(values, asked));
            ++compared;
        }
    }
    CHECK(compared == static_cast<std::size_t>(contacts) * places);
}

} // namespace

TEST_CASE("12 drawn axisymmetric contacts agree with integrals of g' to 50 digits at 5 places") {
    compare_bodies(12, 5);
}
TEST_CASE("60 drawn axisymmetric contacts agree with integrals of g' to 50 digits at 500 places" *
          doctest::test_suite("slow")) {
    compare_bodies(60, 500);
}

TEST_CASE("the coefficients of 60 drawn axisymmetric contacts agree with divided differences" *
          doctest::test_suite("slow")) {
    BodyDraw draw(350);
    for (long number = 0; number < 60; ++number) {
        const DrawnBody body = draw.body(number);
        CAPTURE(body.scene);
        const auto k = static_cast<std::size_t>((number / 6 + number) % 3);
        const unsigned digits = difference_digits(k, agreed_digits);
        const scene::Scene scene = scene::parse_scene(body.scene, "drawn.toml");
        const scene::AskedValue radius{scene::Quantity::a};
        scene::SceneValues more(scene, {radius}, {digits + 60, Rounding::nearest, false});
        const Ball known = value_in_body(more, radius);
        const PrecisionScope scope(digits + 70);
        const Real a = at_working_precision(known.midpoint());
        Real reach = a;
        for (const std::string& knot : body.knots) {
            const Real v = Exact::parse(knot).to<Real>();
            reach = v < a ? std::min(reach, Real(a - v)) : reach;
        }
        const AbelQuadrature second(scene, a, digits);
        scene::AskedValue asked{scene::Quantity::c};
        asked.k = k;
        scene::SceneValues values(scene, {asked}, {agreed_digits, Rounding::nearest, false});
        check_digits(coefficient_by_differences(k, agreed_digits, reach,
                                                [&](const Real& u) { return second.pressure(u); }),
                     value_in_body(values, asked));
    }
}

namespace {

/// g(r), the integral of g'.
Real height_of(const scene::Scene& scene, const Real& r) {
    const contact::SlopeIn<Real> slope(scene.round->profile);
    if (scene.round->law) {
        const Real m = scene.round->profile.parameters().at("m").to<Real>();
        return scene.round->profile.parameters().at("C").to<Real>() * pow(r, Real(m + 1)) / (m + 1);
    }
    Real sum = 0;
    Real from = 0;
    for (std::size_t i = slope.origin() + 1; from < r; ++i) {
        const Real to = i < slope.knots().size() && slope.knots()[i] < r ? slope.knots()[i] : r;
        sum += (to - from) * (slope.value(i, from) + slope.value(i, to)) / 2;
        from = to;
    }
    return sum;
}

/// K(k) with k'^2 = 1 - k^2, by the arithmetic-geometric mean (DLMF 19.8.5).
Real complete_integral(const Real& k_complement) {
    Real mean = 1;
    Real root = k_complement;
    while (abs(Real(mean - root)) > mean * Real("1e-40")) {
        const Real next = (mean + root) / 2;
        root = sqrt(Real(mean * root));
        mean = next;
    }
    return pi<Real>() / (2 * mean);
}

} // namespace

// A ring of pressure displaces the surface of a half-space by an elliptic integral (johnson1985,
// eqs. 3.96, 3.97 and section 3.8): u_z(r) = 4/(pi E*) times the integral of
// p(s) s/(r + s) K(2 sqrt(r s)/(r + s)) ds over the contact. It is delta - g(r) inside the contact,
// and delta - g(r) plus the gap, which is positive, outside.
TEST_CASE("Boussinesq's integral of the pressures of 60 drawn axisymmetric contacts" *
          doctest::test_suite("slow")) {
    BodyDraw draw(350);
    for (long number = 0; number < 60; ++number) {
        const DrawnBody body = draw.body(number);
        CAPTURE(body.scene);
        const scene::Scene scene = scene::parse_scene(body.scene, "drawn.toml");
        constexpr scene::Digits many{60, Rounding::nearest, false};
        scene::SceneValues whole(
            scene, {{scene::Quantity::a}, {scene::Quantity::P}, {scene::Quantity::delta}}, many);
        const auto known = [&](scene::Quantity quantity) {
            return at_working_precision(value_in_body(whole, {quantity}).midpoint());
        };
        const PrecisionScope scope(55);
        const Real a = known(scene::Quantity::a);
        const Real delta = known(scene::Quantity::delta);
        const Real modulus = scene.contact_modulus.to<Real>();
        const Real inside = a * Real(draw.decimal(6));
        const Real outside(decimals_of(Real(a * (1 + Real(draw.decimal(6))))));
        scene::AskedValue first{scene::Quantity::p};
        first.u = Exact::parse("1e-30");
        scene::SceneValues values(scene, {first}, {20, Rounding::nearest, false});
        std::map<std::string, Real> pressures; // both places use the same
        // Where p may be infinite, nodes that are rounded to the place itself are negligible.
        std::vector<Real> infinite_at{a};
        for (const std::string& knot : body.knots) {
            infinite_at.push_back(a - Exact::parse(knot).to<Real>());
        }
        const auto pressure = [&](const Real& u) {
            for (const Real& at : infinite_at) {
                if (abs(Real(u - at)) < a * Real("1e-30")) {
                    return Real(0);
                }
            }
            const std::string text = decimals_of(u);
            if (const auto found = pressures.find(text); found != pressures.end()) {
                return found->second;
            }
            scene::AskedValue asked{scene::Quantity::p};
            asked.u = Exact::parse(text);
            return pressures[text] = at_working_precision(value_in_body(values, asked).midpoint());
        };
        std::vector<Real> ends{Real(0), inside, a};
        for (const std::string& knot : body.knots) {
            const Real v = Exact::parse(knot).to<Real>();
            if (v < a) {
                ends.push_back(v);
            }
        }
        std::ranges::sort(ends);
        const auto over_contact = [&](const auto& f) {
            Real sum = 0;
            for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
                const Real width = ends[i + 1] - ends[i];
                sum += width * quadrature::tanh_sinh<Real>(
                                   [&](const Real& lo, const Real& hi) {
                                       const Real u = (a - ends[i + 1]) + width * hi;
                                       const Real s = ends[i] + width * lo;
                                       // the distance from the place inside
                                       const Real apart =
                                           ends[i] < inside
                                               ? Real((inside - ends[i + 1]) + width * hi)
                                               : Real((ends[i] - inside) + width * lo);
                                       return Real(pressure(u) * f(s, apart));
                                   },
                                   {.target_digits = 18})
                                   .value;
            }
            return sum;
        };
        const auto lifted = [&](const Real& r, const Real& s, const Real& apart) {
            return Real(4 / (pi<Real>() * modulus) * s / (r + s) *
                        complete_integral(Real(apart / (r + s))));
        };
        const Real P = known(scene::Quantity::P);
        CHECK(abs(Real(2 * pi<Real>() * over_contact([](const Real& s, const Real&) { return s; }) -
                       P)) < P * Real("1e-14"));
        const Real within = over_contact(
            [&](const Real& s, const Real& apart) { return lifted(inside, s, apart); });
        CHECK(abs(Real(within - (delta - height_of(scene, inside)))) < delta * Real("1e-14"));
        scene::AskedValue asked{scene::Quantity::gap};
        asked.place = scene::Place::parse(decimals_of(outside), scene::Place::From::origin, {})
                          .distance(contact::Edge::right);
        scene::SceneValues surface(scene, {asked}, many);
        const Real gap = at_working_precision(value_in_body(surface, asked).midpoint());
        CHECK(gap > 0);
        const Real beyond = over_contact(
            [&](const Real& s, const Real&) { return lifted(outside, s, Real(outside - s)); });
        CHECK(abs(Real(beyond - (delta - height_of(scene, outside) + gap))) <
              beyond * Real("1e-14"));
    }
}
