// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/stress/plane_stress.hpp"

#include "edgeproof/contact/curved/integrated_contact.hpp"
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
                quadrature::tanh_sinh(
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
                    stress_of(c.cauchy_integral(zeta), cauchy_integral(e, load, zeta), zeta,
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

// For g' = x + x^3, E* = 1 and the edges -1 and 1 the pressure is (x^2 + 3/2) sqrt(1 - x^2)/2,
// since g' is the polynomial part of (x^2 + 3/2) sqrt(x^2 - 1) at infinity.
TEST_CASE("the Cauchy integral of a curved slope has its digits next to an edge") {
    const Profile cubic = scenes::curve("", "x + x^3", true);
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
        const CauchyIntegral here = contact.cauchy_integral(zeta, {});
        CHECK(abs(here.value - value).upper() < Real("1e-40"));
        CHECK(abs(here.derivative - rate).upper() < Real("1e-25") * abs(rate).lower());
    }
}
