// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/stress/plane_stress.hpp"

#include "edgeproof/contact/curved/integrated_contact.hpp"
#include "edgeproof/contact/profile/slope.hpp"
#include "edgeproof/contact/stress/surface_gap.hpp"
#include "edgeproof/formula/parse.hpp"
#include "edgeproof/quadrature/near_singularity.hpp"
#include "edgeproof/quadrature/tanh_sinh.hpp"
#include "tests/contact/scenes.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <functional>
#include <vector>

namespace {

constexpr long stress_bits = 200;

Ball stress_ball(const char* text) {
    return formula::enclosed_constant(scenes::exact(text), stress_bits);
}

/// A traction by the distances from the edges.
using SurfaceTraction = std::function<Real(Edge, const Real&)>;

/// The places at which the integrals are divided: the edges, the knots and x.
std::vector<Real> division_of(const BallContact& c, const Real& x) {
    std::vector<Real> at{at_working_precision(Real(-c.b().midpoint())),
                         at_working_precision(c.a().midpoint())};
    for (const Ball& knot : c.slope().knots) {
        at.push_back(at_working_precision(knot.midpoint()));
    }
    at.push_back(x);
    std::erase_if(at, [&](const Real& s) { return s < at[0] || s > at[1]; });
    std::sort(at.begin(), at.end());
    return at;
}

struct JohnsonIntegrals {
    Real sxx;
    Real szz;
    Real sxz;
};

/// `johnson1985`, eq. 2.23, by tanh-sinh quadrature.
JohnsonIntegrals stress_by_quadrature(const BallContact& c, const SurfaceTraction& p,
                                      const SurfaceTraction& q, const Real& x, const Real& z) {
    const Real a = c.a().midpoint();
    const Real b = c.b().midpoint();
    const std::vector<Real> at = division_of(c, x);
    JohnsonIntegrals sum{Real(0), Real(0), Real(0)};
    for (std::size_t i = 0; i + 1 < at.size(); ++i) {
        const Real length = at[i + 1] - at[i];
        if (length == 0) {
            continue;
        }
        const auto part = [&](const auto& kernel) {
            return Real(
                quadrature::tanh_sinh<Real>(
                    [&](const Real& lo, const Real& hi) {
                        const Real s = at[i] + length * lo;
                        const Edge edge = s > 0 ? Edge::right : Edge::left;
                        const Real u = edge == Edge::right ? Real(a - at[i + 1] + length * hi)
                                                           : Real(b + at[i] + length * lo);
                        const Real d = x - s;
                        const Real r2 = d * d + z * z;
                        return Real(kernel(d, Real(r2 * r2), p(edge, u), q(edge, u)) * length);
                    },
                    {.target_digits = 25})
                    .value);
        };
        sum.sxx += part([&](const Real& d, const Real& r4, const Real& n, const Real& t) {
            return Real((n * z * d * d + t * d * d * d) / r4);
        });
        sum.szz += part([&](const Real& d, const Real& r4, const Real& n, const Real& t) {
            return Real((n * z * z * z + t * z * z * d) / r4);
        });
        sum.sxz += part([&](const Real& d, const Real& r4, const Real& n, const Real& t) {
            return Real((n * z * z * d + t * z * d * d) / r4);
        });
    }
    const Real factor = Real(-2) / edgeproof::pi<Real>();
    return {Real(sum.sxx * factor), Real(sum.szz * factor), Real(sum.sxz * factor)};
}

bool agrees_in_stress(const Ball& x, const Real& y, const Real& scale) {
    return x.is_finite() && abs(Real(x.midpoint() - y)) < scale * Real("1e-18") &&
           x.radius() < scale * Real("1e-30");
}

} // namespace

TEST_CASE("stresses agree with Johnson's integrals by quadrature") {
    const PrecisionScope precision(60);
    std::vector<scenes::Contact> contacts = scenes::symmetric();
    for (const auto& c : scenes::tilted()) {
        contacts.push_back(c);
    }
    for (const auto& scene : contacts) {
        CAPTURE(scene.name);
        const BallContact c(scene.profile, scene.modulus, scene.load, stress_bits);
        const Extent<Ball> e{c.a(), c.b()};
        const ShearLoad<Ball> load{c.force() * stress_ball("3/10"),
                                   c.force() / e.length() * stress_ball("2/7")};
        const SurfaceTraction p = [&](Edge edge, const Real& u) {
            const Ball value = c.pressure(edge, Ball(u, stress_bits));
            // on a corner, to the digits of u: a logarithm, whose integral there is negligible
            return value.is_finite() ? value.midpoint() : Real(0);
        };
        const SurfaceTraction q = [&](Edge edge, const Real& u) {
            return full_stick_traction(e.length(), load, edge, Ball(u, stress_bits)).midpoint();
        };
        const Ball scale = c.force() / e.length();
        for (const std::string x : {"-13/10", "-1/3", "1/7", "19/20", "2"}) {
            for (const std::string z : {"1/20", "3/4", "30"}) {
                CAPTURE(x);
                CAPTURE(z);
                const Box zeta(stress_ball(x.c_str()) * e.a, stress_ball(z.c_str()) * e.a);
                const StressState s =
                    stress_of(cauchy_integral(c, zeta), cauchy_integral(e, load, zeta), zeta,
                              Ball(0, stress_bits));
                const JohnsonIntegrals i = stress_by_quadrature(c, p, q, zeta.real().midpoint(),
                                                                zeta.imaginary().midpoint());
                CHECK(agrees_in_stress(s.sxx, i.sxx, scale.midpoint()));
                CHECK(agrees_in_stress(s.szz, i.szz, scale.midpoint()));
                CHECK(agrees_in_stress(s.sxz, i.sxz, scale.midpoint()));
            }
        }
    }
}

// h' = g' - (2/(pi E*)) P_1 on the surface outside (johnson1985, eq. 2.25a), integrated by
// tanh-sinh quadrature; P_1 is compared with Johnson's integrals above.
TEST_CASE("the gap outside the contact is the integral of its slope") {
    const PrecisionScope precision(60);
    std::vector<scenes::Contact> contacts = scenes::symmetric();
    for (const auto& c : scenes::tilted()) {
        contacts.push_back(c);
    }
    for (const auto& scene : contacts) {
        CAPTURE(scene.name);
        const BallContact c(scene.profile, scene.modulus, scene.load, stress_bits);
        const RealSlope slope(scene.profile);
        const Real factor = 2 / (edgeproof::pi<Real>() * c.modulus().midpoint());
        for (const Edge edge : {Edge::right, Edge::left}) {
            const Real sign = edge == Edge::right ? Real(1) : Real(-1);
            // an exact midpoint has only as many digits as it needs
            const Real end = at_working_precision((edge == Edge::right ? c.a() : c.b()).midpoint());
            for (const std::string part : {"1e-9", "1/3", "2", "1e4"}) {
                CAPTURE(part);
                const Ball beyond = stress_ball(part.c_str()) * c.a();
                std::vector<Real> at{end, Real(end + at_working_precision(beyond.midpoint()))};
                for (const Ball& knot : c.slope().knots) {
                    const Real place = sign * knot.midpoint();
                    if (at[0] < place && place < at[1]) {
                        at.push_back(at_working_precision(place));
                    }
                }
                std::sort(at.begin(), at.end());
                Real gap(0);
                for (std::size_t i = 0; i + 1 < at.size(); ++i) {
                    const Real length = at[i + 1] - at[i];
                    const auto rate = [&](const Real& lo, const Real&) {
                        const Real x = sign * (at[i] + length * lo);
                        std::size_t piece = 0;
                        while (piece < slope.knots().size() && slope.knots()[piece] < x) {
                            ++piece;
                        }
                        const Box zeta(Ball(x, stress_bits), Ball(0, stress_bits));
                        return Real((slope.value(piece, x) -
                                     factor * cauchy_integral(c, zeta).value.real().midpoint()) *
                                    sign * length);
                    };
                    gap += quadrature::tanh_sinh<Real>(rate, {.target_digits = 20}).value;
                }
                const Ball found = gap_beyond(c, edge, beyond);
                CAPTURE(found.midpoint().str(20));
                CAPTURE(gap.str(20));
                CHECK(found.is_finite());
                CHECK(abs(Real(found.midpoint() - gap)) < Real("1e-15") * gap);
                CHECK(found.radius() < Real("1e-30") * gap);
            }
        }
    }
}

// A wedge: 0.3 far - (2/(pi E*)) integral of p(s) ln((x - s)/(a - s)) ds with p = (0.3 E*/pi)
// arcosh(a/|s|), by mpmath's quad at 25 digits. A cylinder: (a^2/(2R)) (s sqrt(s^2 - 1) - arcosh s)
// with s = x/a (johnson1985, sec. 5.4).
TEST_CASE("gaps of a wedge and of a cylinder from other sources") {
    const BallContact wedge(Profile::power_law(scenes::exact("0.3"), scenes::exact("0")),
                            scenes::exact("7/3"), Load::right_edge(scenes::exact("3/2")),
                            stress_bits);
    const auto differs = [](const Ball& x, const char* value) {
        return abs(Ball(x - stress_ball(value))).upper() > Real("1e-21");
    };
    CHECK_FALSE(
        differs(gap_beyond(wedge, Edge::left, stress_ball("3")), "0.5529418233773775150391624"));
    CHECK_FALSE(differs(gap_beyond(wedge, Edge::right, stress_ball("1/2")),
                        "0.04820872690210944568859567"));
    const BallContact cylinder(Profile::power_law(scenes::exact("1/70"), scenes::exact("1")),
                               scenes::exact("5"), Load::right_edge(scenes::exact("2")),
                               stress_bits);
    for (const char* part : {"1e-12", "1/2", "7"}) {
        const Ball s = 1 + stress_ball(part);
        const Ball expected = (s * sqrt(s * s - 1) - acosh(s)) * 2 / 70;
        CHECK(overlaps(gap_beyond(cylinder, Edge::right, stress_ball(part) * 2), expected));
    }
}

TEST_CASE("on the contact the stress is the traction, and the surface strains are those of g'") {
    for (const auto& scene : scenes::tilted()) {
        CAPTURE(scene.name);
        const BallContact c(scene.profile, scene.modulus, scene.load, stress_bits);
        const Extent<Ball> e{c.a(), c.b()};
        const ShearLoad<Ball> load{stress_ball("3/10"), stress_ball("2/7")};
        for (const char* part : {"1e-20", "1/7", "2/3"}) {
            const Ball u = e.length() * stress_ball(part);
            const Box zeta(e.a - u, Ball(0, stress_bits));
            const StressState s = stress_of(
                cauchy_integral(c, zeta), cauchy_integral(e, load, zeta), zeta, stress_ball("1/9"));
            const Ball p = c.pressure(Edge::right, u);
            CHECK(overlaps(s.szz, -p));
            CHECK(overlaps(s.sxz, -full_stick_traction(e.length(), load, Edge::right, u)));
            // The principal value of q under full stick is pi sigma_0/4 (law/shear.hpp).
            CHECK(overlaps(s.sxx, -p + load.bulk_tension / 2 + stress_ball("1/9")));
            CHECK(s.sxx.radius() < Real("1e-30"));
        }
    }
}

// An exponent that is not whole takes the hypergeometric function; P is continuous in m. (Nearer to
// an even m that function loses its digits.)
TEST_CASE("the recurrence of whole exponents agrees with the hypergeometric function") {
    for (const char* m : {"2", "3", "10", "17"}) {
        const std::string near = std::string(m) + " + 1e-12";
        const auto contact_of = [](const std::string& exponent) {
            return BallContact(
                Profile::power_law(scenes::exact("1/3"), scenes::exact(exponent.c_str())),
                scenes::exact("2"), Load::right_edge(scenes::exact("3/2")), stress_bits);
        };
        const BallContact whole = contact_of(m);
        const BallContact other = contact_of(near);
        const std::pair<const char*, const char*> places[] = {
            {"0", "1/10"}, {"1/7", "1e-20"},  {"3/2", "1/8"}, {"3/2 + 1e-9", "0"}, {"-1/2", "2"},
            {"2", "1/3"},  {"-7/4", "1e-12"}, {"9/5", "0"},   {"-5/3", "0"}};
        for (const auto& [x_text, z_text] : places) {
            const char* const x = x_text; // clang's CAPTURE takes no structured binding
            const char* const z = z_text;
            CAPTURE(whole.power_law()->exponent.midpoint());
            CAPTURE(x);
            CAPTURE(z);
            const Box at(stress_ball(x), stress_ball(z));
            const CauchyIntegral here = cauchy_integral(whole, at);
            const CauchyIntegral there = cauchy_integral(other, at);
            CHECK(abs(here.value - there.value).upper() < Real("1e-10") * abs(there.value).lower());
            CHECK(abs(here.derivative - there.derivative).upper() <
                  Real("1e-10") * abs(there.derivative).lower());
        }
    }
}

// For g' = x + x^3, E* = 1 and the edges -1 and 1 the pressure is (x^2 + 3/2) sqrt(1 - x^2)/2,
// since g' is the polynomial part of (x^2 + 3/2) sqrt(x^2 - 1) at infinity.
TEST_CASE("the Cauchy integral of a curved slope has its digits next to an edge") {
    const Profile cubic =
        Profile::piecewise_symmetric({}, {formula::parse("x + x^3", formula::Symbols({"x"}))});
    const IntegratedContact contact(cubic, scenes::exact("1"), Load::right_edge(scenes::exact("1")),
                                    stress_bits);
    const char* const places[][2] = {{"1", "1e-8"},   {"1", "1e-9"},          {"1", "1e-30"},
                                     {"-1", "1e-30"}, {"1 + 1e-12", "1e-20"}, {"999/1000", "1e-9"}};
    for (const auto& place : places) {
        CAPTURE(std::string(place[0]));
        CAPTURE(std::string(place[1]));
        const Box zeta(stress_ball(place[0]), stress_ball(place[1]));
        const Box root = root_outside({Ball(1, stress_bits), Ball(1, stress_bits)}, zeta);
        const Box square = zeta * zeta;
        const Ball half_pi = Ball::pi(stress_bits) / 2;
        const Box factor = square + Box(stress_ball("3/2"));
        const Box value = (zeta + zeta * square - factor * root) * half_pi;
        const Box rate = (square * Ball(3, stress_bits) + 1 - zeta * root * Ball(2, stress_bits) -
                          factor * zeta / root) *
                         half_pi;
        const CauchyIntegral here = contact.cauchy_integral(zeta);
        CHECK(abs(here.value - value).upper() < Real("1e-40"));
        CHECK(abs(here.derivative - rate).upper() < Real("1e-25") * abs(rate).lower());
    }
}
