// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/routes/partial_slip.hpp"

#include "edgeproof/contact/stress/dissipation.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/quadrature/near_singularity.hpp"
#include "tests/contact/slip_scenes.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

using scenes::size_cases, scenes::SizeCase, scenes::slip_bits, scenes::Slipping, scenes::slipping;

namespace {

constexpr unsigned route_digits = 32;

/// Returns the shear of a slip in balls as exact numbers: Q and sigma_0 to far more digits than
/// needed.
ShearSpec shear_of(const Slipping& s, const char* tau, const char* r) {
    const Ball Q = formula::enclosed_constant(scenes::exact(tau), slip_bits) *
                   Ball(Rational(3, 5), slip_bits) * s.force();
    ShearSpec spec;
    spec.Q = scenes::exact(Q.midpoint().str(110));
    spec.bulk_tension = Exact::of(Rational(scenes::exact(r).rational() * spec.Q.rational()));
    spec.friction = scenes::exact("3/5");
    return spec;
}

/// The traction q in balls, to far more digits than needed, at a distance from an edge.
class Traction {
public:
    explicit Traction(const Slipping& s) : s_(s) {}
    Real operator()(Edge edge, const Real& u) const {
        const Ball q = at(edge, Ball(u, slip_bits));
        // On a corner p and p* are infinite, but q is finite: use a point near it.
        return (q.is_finite() ? q : at(edge, Ball(Real(u * (1 + Real("1e-48"))), slip_bits)))
            .midpoint();
    }

private:
    [[nodiscard]] Ball at(Edge edge, const Ball& u) const {
        return s_.slip->traction(edge, u, s_.contact().pressure(edge, u));
    }
    const Slipping& s_;
};

struct Integrals {
    Real resultant;
    Real principal_value;
};

/// Returns the integral of q, and PV of q/(s - x), split at the stick zone's edges and the knots,
/// by the distances from the edges; x is at the distance `at` from the right edge, in the stick
/// zone.
Integrals put_back(const Slipping& s, const Real& at) {
    const Traction q(s);
    const auto number = [](const Ball& x) { return Real(x.midpoint()); };
    const Real D = number(s.slip->whole().length());
    const Real a = number(s.slip->whole().a);
    // Distances from the right edge.
    std::vector<Real> cuts{Real(0), D, number(s.slip->size(Edge::right)),
                           Real(D - number(s.slip->size(Edge::left)))};
    for (const char* v : {"-0.4", "0.4", "0", "-pi/8", "-pi/8 - 2"}) {
        const Real u = a - scenes::exact(v).to<Real>();
        if (u > 0 && u < D) {
            cuts.push_back(u);
        }
    }
    Real half = D;
    for (const Real& c : cuts) {
        half = abs(Real(c - at)) > 0 ? std::min(half, Real(abs(Real(c - at)) / 2)) : half;
    }
    cuts.push_back(Real(at - half));
    cuts.push_back(Real(at + half));
    std::sort(cuts.begin(), cuts.end());
    cuts.erase(std::unique(cuts.begin(), cuts.end(),
                           [](const Real& x, const Real& y) { return abs(Real(x - y)) < 1e-30; }),
               cuts.end());
    const auto value = [&](std::size_t i, const Real& lo, const Real& hi) {
        const Real u = cuts[i] + lo;
        const bool last = i + 2 == cuts.size();
        return last ? q(Edge::left, hi) : q(Edge::right, u);
    };
    Integrals sum{Real(0), Real(0)};
    const quadrature::QuadratureOptions options{.target_digits = route_digits};
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
        const Real length = cuts[i + 1] - cuts[i];
        sum.resultant += quadrature::integrate_one_sided<Real>(
                             [&](const Real& lo, const Real& hi) { return value(i, lo, hi); },
                             length, Real(0), true, options)
                             .value;
        if (abs(Real(cuts[i] - (at - half))) < 1e-30) {
            continue; // the part about x is added below
        }
        // s - x = at - u
        sum.principal_value += quadrature::integrate_one_sided<Real>(
                                   [&](const Real& lo, const Real& hi) {
                                       return Real(value(i, lo, hi) / (at - cuts[i] - lo));
                                   },
                                   length, Real(0), true, options)
                                   .value;
    }
    sum.principal_value +=
        quadrature::integrate_one_sided<Real>(
            [&](const Real& y, const Real&) {
                return Real((q(Edge::right, Real(at - y)) - q(Edge::right, Real(at + y))) / y);
            },
            half, Real(0), true, options)
            .value;
    return sum;
}

constexpr long cycle_bits = 256;

Real energy_in_real(const Slipping& s, const Profile& profile, const char* modulus, const char* a,
                    const char* tau) {
    const NormalContact contact(Profile(profile), scenes::exact(modulus),
                                Load::right_edge(scenes::exact(a)), 26);
    ShearSpec shear;
    const Ball Q = formula::enclosed_constant(scenes::exact(tau), cycle_bits) *
                   Ball(Rational(3, 5), cycle_bits) * s.force();
    shear.Q = scenes::exact(Q.midpoint().str(60));
    shear.bulk_tension = scenes::exact("0");
    shear.friction = scenes::exact("3/5");
    const PartialSlip slip(contact, shear);
    return cycle_energy(contact, slip, *shear.friction);
}

bool within(const Real& x, const Real& y, const char* relative) {
    const PrecisionScope scope(40);
    return abs(Real(x / y - 1)) < Real(relative);
}

} // namespace

// The second route uses neither the corrective contact nor the law of the profile.
TEST_CASE(
    "slip zones and tractions in balls agree with those from the pressures in the slip zones") {
    for (const SizeCase& c : size_cases()) {
        CAPTURE(c.name);
        const Slipping s = slipping(c.profile, c.modulus, c.a, "3/10", c.r);
        const PrecisionScope scope(60);
        const ShearSpec spec = shear_of(s, "3/10", c.r);
        const NormalContact contact(Profile(c.profile), scenes::exact(c.modulus),
                                    Load::right_edge(scenes::exact(c.a)), route_digits);
        const PartialSlip slip(contact, spec);
        CHECK(scenes::agree(slip.size(Edge::right), scenes::exact(c.right).to<Real>(), 30));
        CHECK(scenes::agree(slip.size(Edge::left), scenes::exact(c.left).to<Real>(), 30));
        const Real D = contact.a() + contact.b();
        for (const char* part : {"1/50", "1/3", "2/3", "49/50"}) {
            CAPTURE(part);
            const Exact u = scenes::exact(Real(D * scenes::exact(part).to<Real>()).str(40));
            const Ball from = formula::enclosed_constant(u, slip_bits);
            const Ball q =
                s.slip->traction(Edge::right, from, s.contact().pressure(Edge::right, from));
            CHECK(q.relative_accuracy_bits() > 200);
            CHECK(scenes::agree(slip.traction(Edge::right, u), q.midpoint(), 30));
            CHECK(slip.sticks(Edge::right, u.to<Real>()) ==
                  (s.slip->state(Edge::right, from) == SlipState::stick));
        }
        const auto series = slip.series(4);
        const auto enclosed = s.slip->series(4);
        for (std::size_t k = 0; k < 4; ++k) {
            // For a wedge they are zero from the second on.
            CHECK(abs(Real(series.right[k] - enclosed.right[k].midpoint())) < D * Real("1e-28"));
            CHECK(abs(Real(series.left[k] - enclosed.left[k].midpoint())) < D * Real("1e-28"));
        }
    }
}

// The strains of both bodies are equal in the stick zone (docs/shear.md): PV of q/(s - x) is pi
// sigma_0/4 there. In the slip zones |q| = f p. The resultant is Q.
TEST_CASE("q in the integral equation gives sigma_0 and Q, to 30 digits") {
    const auto all = size_cases();
    for (const std::size_t i : {1UL, 4UL, 7UL, 9UL}) {
        const SizeCase& c = all[i];
        CAPTURE(c.name);
        const PrecisionScope scope(55);
        const Slipping s = slipping(c.profile, c.modulus, c.a, "3/10", c.r);
        const Real Q = Real(Ball(Rational(9, 50), slip_bits).midpoint()) * s.force().midpoint();
        const Real sigma = scenes::exact(c.r).to<Real>() * Q;
        const Real d = s.slip->size(Edge::right).midpoint();
        const Real stick = s.slip->stick().length().midpoint();
        for (const char* part : {"0.21", "0.83"}) {
            CAPTURE(part);
            const Integrals sum = put_back(s, Real(d + stick * scenes::exact(part).to<Real>()));
            CHECK(scenes::agree(sum.resultant, Q, 30));
            const Real expected = pi<Real>() * sigma / 4;
            CHECK(abs(Real(sum.principal_value - expected)) < abs(Q / stick) * Real("1e-30"));
        }
        // q <= f p throughout, with equality in the slip zones.
        const Traction q(s);
        for (const char* part : {"0.3", "0.9", "1.0000001", "1.5"}) {
            const Real u = d * scenes::exact(part).to<Real>();
            const Real p = s.contact().pressure(Edge::right, Ball(u, slip_bits)).midpoint();
            const Real most = p * 3 / 5;
            const Real value = q(Edge::right, u);
            CHECK(value > 0);
            CHECK((u < d ? scenes::agree(value, most, 50) : value < most));
        }
    }
}

TEST_CASE("a contact that slides has no stick zone, in either route") {
    const Profile hertz = Profile::power_law(scenes::exact("1"), scenes::exact("1"));
    const Slipping s = slipping(hertz, "1", "1", "11/10", "0");
    CHECK(s.slip->sliding());
    const PrecisionScope scope(40);
    const ShearSpec spec = shear_of(s, "11/10", "0");
    const NormalContact contact(Profile(hertz), scenes::exact("1"),
                                Load::right_edge(scenes::exact("1")), 20);
    CHECK_THROWS_AS(PartialSlip(contact, spec), InputError);
}

// tests/contact/stress/cycle_energy_test.cpp gives the source of the value of the tilted punch.
TEST_CASE("the energy of a cycle by quadrature: a tilted punch, and closed forms") {
    const PrecisionScope scope(40);
    for (const scenes::SizeCase& c : size_cases()) {
        const bool punch = c.name == "tilted flat and rounded";
        if (!punch && c.name != "tilted wedge" && c.name != "cubic") {
            continue;
        }
        CAPTURE(c.name);
        const Slipping s = slipping(c.profile, c.modulus, c.a, "3/10", c.r, cycle_bits);
        const Real W = energy_in_real(s, c.profile, c.modulus, c.a, "3/10");
        const Real expected =
            punch ? Real("0.0775464093049073581084124865")
                  : similar_cycle_energy(*s.slip, Ball(c.name == "cubic" ? 4 : 1, cycle_bits))
                        .midpoint();
        CHECK(within(W, expected, "1e-24"));
    }
}

TEST_CASE("the energy of a cycle by quadrature keeps its digits under little shear") {
    const PrecisionScope scope(40);
    for (const scenes::SizeCase& c : size_cases()) {
        if (c.name != "tilted wedge") {
            continue;
        }
        const char* tau = "1e-30";
        const Slipping s = slipping(c.profile, c.modulus, c.a, tau, "0", 2 * cycle_bits);
        const Ball closed = similar_cycle_energy(*s.slip, Ball(1, 2 * cycle_bits));
        CHECK(
            within(energy_in_real(s, c.profile, c.modulus, c.a, tau), closed.midpoint(), "1e-24"));
    }
}

TEST_CASE("the energy of a cycle in balls and by quadrature agree where slip passes a knot") {
    const formula::Symbols x{"x"};
    const Profile profile = Profile::piecewise_symmetric(
        {scenes::exact("1/2")}, {formula::parse("x/10", x), formula::parse("x - 9/20", x)});
    const Slipping s = slipping(profile, "1", "3/5", "9/10", "0", cycle_bits);
    REQUIRE(certainly_less(s.slip->stick().a, Ball(Rational(1, 2), cycle_bits)));
    const Real in_balls = cycle_energy(*s.slip, growth_of(*s.of->closed_form())).midpoint();
    CHECK(within(energy_in_real(s, profile, "1", "3/5", "9/10"), in_balls, "1e-24"));
}

TEST_SUITE_BEGIN("slow");

TEST_CASE("the energy of a cycle by quadrature where slip passes corners") {
    const formula::Symbols x{"x"};
    const Profile profile = Profile::piecewise_symmetric(
        {scenes::exact("1/2")}, {formula::parse("x/10", x), formula::parse("x/10 + 1/5", x)});
    const Slipping s = slipping(profile, "1", "3/5", "99/100", "0", cycle_bits);
    REQUIRE(certainly_less(s.slip->stick().a, Ball(Rational(1, 2), cycle_bits)));
    const Real in_balls = cycle_energy(*s.slip, growth_of(*s.of->closed_form())).midpoint();
    CHECK(within(energy_in_real(s, profile, "1", "3/5", "99/100"), in_balls, "1e-24"));
}

TEST_SUITE_END();
