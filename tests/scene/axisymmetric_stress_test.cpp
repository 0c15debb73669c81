// SPDX-License-Identifier: GPL-3.0-or-later
// Stresses of axisymmetric contacts without shear, and the slip.
#include "edgeproof/precision/error.hpp"
#include "edgeproof/quadrature/tanh_sinh.hpp"
#include "edgeproof/scene/run_scene.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace {

const char* const stressed_sphere = "kind = \"hertz\"\nR = \"1\"\n";
const char* const stressed_punch = "kind = \"flat-and-rounded\"\nt = \"2/5\"\nR = \"1\"\n";

scene::Scene stressed(const std::string& profile, const std::string& rest = "") {
    return scene::parse_scene("[profile]\ngeometry = \"axisymmetric\"\n" + profile +
                                  "[load]\na = \"5/4\"\ncontact_modulus = \"7/3\"\nnu = \"0.3\"\n" +
                                  rest,
                              "stress.toml");
}

Real stress_at(const scene::Scene& s, scene::Quantity quantity, const std::string& x,
               const std::string& z, unsigned digits = 30) {
    scene::AskedValue asked{quantity};
    asked.in_body = {Exact::parse(x), Exact::parse(z)};
    const scene::BoundedValue value =
        scene::SceneValues(s, {asked}, {digits, Rounding::nearest, false}).value(asked);
    CHECK(value.proved);
    return at_working_precision(value.value.midpoint());
}

bool close_to(const Real& x, const Real& y, const char* relative = "1e-28") {
    return abs(Real(x - y)) <= abs(y) * Real(relative);
}

/// p by the scene's own route, which tests/scene/axisymmetric_test.cpp compares with others.
class PressureOf {
public:
    explicit PressureOf(const scene::Scene& s)
        : values_(s, {asked("1/2")}, {20, Rounding::nearest, false}) {}
    Real operator()(const Real& u) {
        if (abs(Real(u - Real(5) / 4)) < Real("1e-30")) {
            return 0; // p may be infinite on the axis, where it has no weight
        }
        const std::string place = u.str(40, std::ios_base::scientific);
        if (const auto known = known_.find(place); known != known_.end()) {
            return known->second;
        }
        return known_[place] = at_working_precision(values_.value(asked(place)).value.midpoint());
    }

private:
    static scene::AskedValue asked(const std::string& u) {
        scene::AskedValue value{scene::Quantity::p};
        value.u = Exact::parse(u);
        return value;
    }
    scene::SceneValues values_;
    std::map<std::string, Real> known_; ///< several integrals use the same places
};

/// The integral of f(r) p(r) r over lo < r < hi.
Real over_ring(PressureOf& p, const Real& lo, const Real& hi,
               const std::function<Real(const Real&)>& f) {
    const Real a = Real(5) / 4;
    return (hi - lo) * quadrature::tanh_sinh<Real>(
                           [&](const Real& from, const Real& to) {
                               const Real r = lo + (hi - lo) * from;
                               const Real u = hi == a ? Real((hi - lo) * to) : Real(a - r);
                               return Real(f(r) * p(u) * r);
                           },
                           {.target_digits = 16})
                           .value;
}

} // namespace

// johnson1985, eq. 3.42 and 3.45
TEST_CASE("the stresses of a sphere agree with the printed formulas") {
    const PrecisionScope precision(50);
    const scene::Scene s = stressed(stressed_sphere);
    const Real a = Real(5) / 4;
    const Real nu = Real(3) / 10;
    const Real p0 = 2 * a * (Real(7) / 3) / edgeproof::pi<Real>();
    for (const char* z_text : {"1e-6", "1/3", "6/5", "50"}) {
        CAPTURE(z_text);
        const Real t = Exact::parse(z_text).to<Real>() / a;
        const Real radial = p0 * (1 / (2 * (1 + t * t)) - (1 + nu) * (1 - t * atan(1 / t)));
        const Real normal = -p0 / (1 + t * t);
        CHECK(close_to(stress_at(s, scene::Quantity::sxx, "0", z_text), radial, "1e-24"));
        CHECK(close_to(stress_at(s, scene::Quantity::szz, "0", z_text), normal));
        CHECK(stress_at(s, scene::Quantity::sxz, "0", z_text) == 0);
        CHECK(close_to(stress_at(s, scene::Quantity::tau_max, "0", z_text),
                       Real((radial - normal) / 2), "1e-24"));
        CHECK(close_to(stress_at(s, scene::Quantity::mises, "0", z_text), Real(radial - normal),
                       "1e-24"));
    }
    CHECK(close_to(stress_at(s, scene::Quantity::sxx, "0", "0"), Real(-p0 * (nu + Real(1) / 2))));
    for (const char* r_text : {"1e-6", "1/3", "6/5", "5/4", "7"}) {
        CAPTURE(r_text);
        const Real x = Exact::parse(r_text).to<Real>() / a;
        const Real root = x < 1 ? Real(sqrt(Real(1 - x * x))) : Real(0);
        const Real spread = (1 - 2 * nu) / (3 * x * x) * (1 - root * root * root);
        const Real radial = p0 * (spread - root);
        const Real hoop = p0 * (-spread - 2 * nu * root);
        CHECK(close_to(stress_at(s, scene::Quantity::sxx, r_text, "0"), radial, "1e-24"));
        CHECK(close_to(stress_at(s, scene::Quantity::sxx, "-" + std::string(r_text), "0"), radial,
                       "1e-24"));
        CHECK(abs(Real(stress_at(s, scene::Quantity::szz, r_text, "0") + p0 * root)) <
              p0 * Real("1e-28"));
        const Real most = std::max({radial, hoop, Real(-p0 * root)});
        const Real least = std::min({radial, hoop, Real(-p0 * root)});
        CHECK(close_to(stress_at(s, scene::Quantity::tau_max, r_text, "0"),
                       Real((most - least) / 2), "1e-24"));
    }
}

namespace {

// Boussinesq's point loads (johnson1985, eq. 3.19) on rings of radius r, with rho^2 = r^2 + z^2: on
// the axis srr = integral of p (3 z^3/(2 rho^5) - (1 + nu) z/rho^3) r dr and szz = -3 z^3 integral
// of p/rho^5 r dr; on the surface srr = (1 - 2 nu) F/r^2 - p with F the integral of p r dr up to r.
void compare_with_rings(const std::vector<std::string>& profiles) {
    const PrecisionScope precision(40);
    const Real nu = Real(3) / 10;
    const Real a = Real(5) / 4;
    for (const std::string& profile : profiles) {
        CAPTURE(profile);
        const scene::Scene s = stressed(profile);
        PressureOf p(s);
        const auto whole = [&](const Real& to, const std::function<Real(const Real&)>& f) {
            Real sum = 0;
            Real from = 0;
            for (const char* knot : {"1/3", "2/5", "1", "5/4"}) {
                const Real end = std::min(Exact::parse(knot).to<Real>(), to);
                if (end > from) {
                    sum += over_ring(p, from, end, f);
                    from = end;
                }
            }
            return sum;
        };
        for (const char* z_text : {"1/4", "2"}) {
            CAPTURE(z_text);
            const Real z = Exact::parse(z_text).to<Real>();
            const auto rho = [&](const Real& r) { return Real(sqrt(Real(r * r + z * z))); };
            const Real third = whole(a, [&](const Real& r) { return Real(z / pow(rho(r), 3)); });
            const Real fifth =
                whole(a, [&](const Real& r) { return Real(z * z * z / pow(rho(r), 5)); });
            CHECK(close_to(stress_at(s, scene::Quantity::szz, "0", z_text), Real(-3 * fifth),
                           "1e-12"));
            CHECK(close_to(stress_at(s, scene::Quantity::sxx, "0", z_text),
                           Real(3 * fifth / 2 - (1 + nu) * third), "1e-12"));
        }
        for (const char* r_text : {"1/5", "2/5", "11/10"}) {
            CAPTURE(r_text);
            const Real r = Exact::parse(r_text).to<Real>();
            const Real inner = whole(r, [](const Real&) { return Real(1); });
            CHECK(close_to(stress_at(s, scene::Quantity::sxx, r_text, "0"),
                           Real((1 - 2 * nu) * inner / (r * r) - p(Real(a - r))), "1e-12"));
        }
    }
}

} // namespace

TEST_CASE("the stresses of axisymmetric power laws are those of their pressure") {
    compare_with_rings({"kind = \"power-law\"\nC = \"1/2\"\nm = \"1/3\"\n",
                        "kind = \"power-law\"\nC = \"1/2\"\nm = \"4\"\n"});
}

TEST_CASE("the stresses of other axisymmetric contacts are those of their pressure" *
          doctest::test_suite("slow")) {
    compare_with_rings({stressed_punch,
                        "kind = \"piecewise\"\nsymmetric = true\nknots = [\"1/3\", \"1\"]\n"
                        "slopes = [\"x\", \"x/2 + 1/2\", \"3*x - 2\"]\n"});
}

namespace {

// huber1904 (fischer-cripps2007, section 5.4), with p_m = 2 p_0/3
void compare_with_huber(const std::vector<std::pair<std::string, std::string>>& points) {
    const PrecisionScope precision(70);
    const scene::Scene s = stressed(stressed_sphere);
    const Real a = Real(5) / 4;
    const Real nu = Real(3) / 10;
    const Real p0 = 2 * a * (Real(7) / 3) / edgeproof::pi<Real>();
    for (const auto& each : points) {
        const auto& r_text = each.first;
        const auto& z_text = each.second;
        CAPTURE(r_text);
        CAPTURE(z_text);
        const Real x = Exact::parse(r_text).to<Real>();
        const Real r = abs(x);
        const Real z = Exact::parse(z_text).to<Real>();
        const Real apart = r * r + z * z - a * a;
        const Real u = (apart + sqrt(Real(apart * apart + 4 * a * a * z * z))) / 2;
        const Real root = sqrt(u);
        const Real ratio = z / root;
        const Real cube = ratio * ratio * ratio;
        const Real spread = (1 - 2 * nu) / 3 * a * a / (r * r) * (1 - cube);
        const Real angle = (1 + nu) * root / a * atan(Real(a / root));
        const Real share = u * (1 - nu) / (a * a + u);
        const Real normal = cube * a * a * u / (u * u + a * a * z * z);
        const Real radial = p0 * (spread + normal + ratio * (share + angle - 2));
        const Real hoop = -p0 * (spread + ratio * (2 * nu + share - angle));
        const Real shear = -p0 * x * z * z / (u * u + a * a * z * z) * a * a * root / (u + a * a);
        const auto at = [&](scene::Quantity quantity) {
            return stress_at(s, quantity, r_text, z_text);
        };
        CHECK(close_to(at(scene::Quantity::sxx), radial));
        CHECK(close_to(at(scene::Quantity::szz), Real(-p0 * normal)));
        CHECK(close_to(at(scene::Quantity::syy), hoop));
        CHECK(close_to(at(scene::Quantity::sxz), shear));
        const Real mean = (radial - p0 * normal) / 2;
        const Real half = (radial + p0 * normal) / 2;
        const Real in_plane = sqrt(Real(half * half + shear * shear));
        const Real most = std::max(Real(mean + in_plane), hoop);
        const Real least = std::min(Real(mean - in_plane), hoop);
        CHECK(close_to(at(scene::Quantity::tau_max), Real((most - least) / 2)));
        CHECK(close_to(at(scene::Quantity::s1), most));
        CHECK(close_to(at(scene::Quantity::s3), least));
        const Real differences =
            pow(Real(2 * half), 2) + pow(Real(radial - hoop), 2) + pow(Real(hoop + p0 * normal), 2);
        CHECK(close_to(at(scene::Quantity::mises),
                       Real(sqrt(Real(differences / 2 + 3 * shear * shear)))));
    }
}

} // namespace

TEST_CASE("the stresses inside the body of a sphere agree with Huber's formulas") {
    compare_with_huber({{"1/3", "1/4"}});
}

TEST_CASE("the stresses of a sphere near the axis, the surface and far away agree with Huber's" *
          doctest::test_suite("slow")) {
    compare_with_huber(
        {{"-1/3", "1/4"}, {"5/4", "1/100"}, {"1e-6", "1"}, {"1/2", "1e-8"}, {"7", "3"}});
}

// Point loads (johnson1985, eq. 3.18) on rings of the radius rho, at the angle phi; the mean over
// the angle by the trapezoidal rule, which converges exponentially.
TEST_CASE(
    "the stresses inside the body of other axisymmetric contacts are those of their pressure" *
    doctest::test_suite("slow")) {
    const PrecisionScope precision(40);
    const Real nu = Real(3) / 10;
    const Real a = Real(5) / 4;
    const Real r = Real(1) / 2;
    const Real z = Real(3) / 4;
    constexpr int angles = 96;
    for (const std::string& profile :
         {std::string("kind = \"power-law\"\nC = \"1/2\"\nm = \"1/3\"\n"),
          std::string("kind = \"power-law\"\nC = \"1/2\"\nm = \"0\"\n"),
          std::string(stressed_punch),
          std::string("kind = \"piecewise\"\nsymmetric = true\nknots = [\"1/3\", \"1\"]\n"
                      "slopes = [\"x\", \"x/2 + 1/2\", \"3*x - 2\"]\n")}) {
        CAPTURE(profile);
        const scene::Scene s = stressed(profile);
        PressureOf p(s);
        const auto whole = [&](const auto& at_point) {
            Real sum = 0;
            Real from = 0;
            for (const char* knot : {"1/3", "2/5", "1", "5/4"}) {
                const Real end = Exact::parse(knot).to<Real>();
                sum += over_ring(p, from, end, [&](const Real& rho) {
                    Real mean = 0;
                    for (int j = 0; j < angles; ++j) {
                        const Real phi = 2 * edgeproof::pi<Real>() * (j + Real(1) / 3) / angles;
                        mean += at_point(Real(r - rho * cos(phi)), Real(rho * sin(phi)));
                    }
                    return Real(mean / angles);
                });
                from = end;
            }
            return sum;
        };
        const auto distance = [&](const Real& x, const Real& y) {
            return Real(sqrt(Real(x * x + y * y + z * z)));
        };
        const Real normal = whole([&](const Real& x, const Real& y) {
            return Real(-3 * z * z * z / pow(distance(x, y), 5));
        });
        const Real shear = whole([&](const Real& x, const Real& y) {
            return Real(-3 * x * z * z / pow(distance(x, y), 5));
        });
        const auto along = [&](const Real& x, const Real& y) {
            const Real R = distance(x, y);
            const Real q = x * x + y * y;
            return Real((1 - 2 * nu) / q *
                            ((1 - z / R) * (x * x - y * y) / q + z * y * y / (R * R * R)) -
                        3 * z * x * x / pow(R, 5));
        };
        const Real radial = whole(along);
        const Real hoop = whole([&](const Real& x, const Real& y) { return along(y, x); });
        const auto at = [&](scene::Quantity quantity) {
            return stress_at(s, quantity, "1/2", "3/4", 20);
        };
        CHECK(close_to(at(scene::Quantity::szz), normal, "1e-12"));
        CHECK(close_to(at(scene::Quantity::sxz), shear, "1e-12"));
        CHECK(close_to(at(scene::Quantity::sxx), radial, "1e-12"));
        CHECK(close_to(at(scene::Quantity::syy), hoop, "1e-12"));
    }
}

// johnson1985, section 3.4: 0.310 p_0 at z = 0.48 a for nu = 0.3; here by golden sections of the
// printed formula.
TEST_CASE("the greatest tau_max on the axis and its place are proved") {
    const PrecisionScope precision(50);
    const scene::Scene s = stressed(stressed_sphere, "[ask]\ndigits = 12\n");
    const scene::GreatestValue found =
        scene::greatest_value(s, scene::Quantity::tau_max, scene::Body::A);
    CHECK(found.value.proved);
    const Real a = Real(5) / 4;
    const Real p0 = 2 * a * (Real(7) / 3) / edgeproof::pi<Real>();
    const auto tau = [](const Real& t) {
        return Real((Real(3) / (2 * (1 + t * t)) - Real(13) / 10 * (1 - t * atan(1 / t))) / 2);
    };
    Real lo("0.2");
    Real hi("0.9");
    for (int i = 0; i < 120; ++i) {
        const Real left = lo + (hi - lo) * Real("0.382");
        const Real right = lo + (hi - lo) * Real("0.618");
        (tau(left) < tau(right) ? lo : hi) = tau(left) < tau(right) ? left : right;
    }
    CHECK(abs(Real(lo - Real("0.481"))) < Real("5e-4"));
    CHECK(abs(Real(tau(lo) - Real("0.310"))) < Real("5e-4"));
    CHECK(
        close_to(at_working_precision(found.value.value.midpoint()), Real(p0 * tau(lo)), "1e-14"));
    CHECK(close_to(at_working_precision(found.z.value.midpoint()), Real(a * lo), "1e-12"));
    // Near the greatest place of another profile no value is greater.
    for (const char* profile : {stressed_punch, "kind = \"power-law\"\nC = \"1\"\nm = \"3\"\n"}) {
        CAPTURE(profile);
        const scene::Scene other = stressed(profile, "[ask]\ndigits = 15\n");
        const scene::GreatestValue most =
            scene::greatest_value(other, scene::Quantity::tau_max, scene::Body::A);
        const Real z = at_working_precision(most.z.value.midpoint());
        const Real value = at_working_precision(most.value.value.midpoint());
        const auto at = [&](const Real& depth) {
            return stress_at(other, scene::Quantity::tau_max, "0",
                             depth.str(30, std::ios_base::scientific));
        };
        CHECK(close_to(at(z), value, "1e-14"));
        for (const char* factor : {"0.001", "0.1", "0.5", "0.99", "1.01", "1.5", "4"}) {
            CHECK(at(Real(z * Real(factor))) < value);
        }
    }
}

TEST_CASE("stresses of axisymmetric contacts that are not computed are refused") {
    const auto refusal = [](const std::string& profile, const std::string& rest) {
        try {
            (void)run_scene(stressed(profile, rest));
        } catch (const Error& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    CHECK(refusal(stressed_sphere, "[ask]\npoints = [[\"0\", \"1\"]]\n").empty());
    CHECK(refusal(stressed_sphere, "[shear]\nQ = \"0.1\"\nfriction = \"1\"\n[ask]\npoints = "
                                   "[[\"0\", \"1\"]]\nquantities = [\"stress\"]\n")
              .find("without shear") != std::string::npos);
    CHECK(refusal("kind = \"power-law\"\nm = \"0\"\nC = \"1\"\n",
                  "[ask]\npoints = [[\"0\", \"0\"]]\n")
              .find("apex") != std::string::npos);
}

// The mean over a circle of the displacement by tractions q(r) in one direction is
// (2 - nu)/(4 pi G) times the integral of q/distance (johnson1985, eq. 3.7 and 3.90): the ratio of
// the slip to the gap of the corrective contact is f (2 - nu)/(2 (1 - nu)) for equal bodies. The
// gap of a sphere of radius c outside it: johnson1985, eq. 3.42a, is
// ((r^2 - 2 c^2) acos(c/r) + c sqrt(r^2 - c^2))/(pi R).
TEST_CASE("the slip of a sphere in partial slip") {
    const PrecisionScope precision(40);
    const scene::Scene s = stressed(stressed_sphere, "[shear]\nQ = \"1/2\"\nfriction = \"1/3\"\n");
    const Real a = Real(5) / 4;
    const Real nu = Real(3) / 10;
    const Real P = Real(4) / 3 * (Real(7) / 3) * a * a * a;
    const Real c = a * pow(Real(1 - Real(3) / 2 / P), Real(1) / 3);
    for (const char* r_text : {"1.2", "1.249", "1/2"}) {
        CAPTURE(r_text);
        const Real r = Exact::parse(r_text).to<Real>();
        const Real gap =
            r < c ? Real(0)
                  : Real(((r * r - 2 * c * c) * acos(Real(c / r)) + c * sqrt(Real(r * r - c * c))) /
                         edgeproof::pi<Real>());
        scene::AskedValue asked{scene::Quantity::slip_displacement};
        asked.place = scene::Distance(formula::Expr::symbol("a") - Exact::parse(r_text).expr(),
                                      Exact::parse(r_text).expr());
        const scene::BoundedValue value =
            scene::SceneValues(s, {asked}, {25, Rounding::nearest, false}).value(asked);
        CHECK(value.proved);
        const Real slip = at_working_precision(value.value.midpoint());
        CHECK(abs(Real(slip + gap / 3 * (2 - nu) / (2 * (1 - nu)))) <= gap * Real("1e-22"));
    }
}

// The gap outside a contact is compared with another route in axisymmetric_profiles_test.cpp.
TEST_CASE("the slip of a body of revolution is in proportion to the gap of the stick zone") {
    const PrecisionScope precision(50);
    const scene::Scene s = stressed(stressed_punch, "[shear]\nQ = \"1/2\"\nfriction = \"1/3\"\n");
    const scene::AskedValue stick{scene::Quantity::stick_a};
    const Real c =
        at_working_precision(scene::SceneValues(s, {stick}, {40, Rounding::nearest, false})
                                 .value(stick)
                                 .value.midpoint());
    const std::string c_text = c.str(40, std::ios_base::scientific);
    scene::Scene inner = stressed(stressed_punch);
    inner.load = contact::Load::right_edge(Exact::parse(c_text));
    inner.round->load = inner.load;
    const auto at = [](const scene::Scene& of, scene::Quantity quantity, const std::string& r) {
        scene::AskedValue asked{quantity};
        asked.place = scene::Distance(formula::Expr::symbol("a") - Exact::parse(r).expr(),
                                      Exact::parse(r).expr());
        const scene::BoundedValue value =
            scene::SceneValues(of, {asked}, {25, Rounding::nearest, false}).value(asked);
        CHECK(value.proved);
        return at_working_precision(value.value.midpoint());
    };
    CHECK(c < Real("1.24"));
    for (const char* r : {"1.24", "1.2499"}) {
        const Real gap = at(inner, scene::Quantity::gap, r);
        CHECK(gap > 0);
        // (2 - nu)/(2 (1 - nu)) = 17/14, f = 1/3
        CHECK(
            close_to(at(s, scene::Quantity::slip_displacement, r), Real(-gap * 17 / 42), "1e-20"));
    }
    CHECK(at(s, scene::Quantity::slip_displacement, "1/2") == 0);
}
