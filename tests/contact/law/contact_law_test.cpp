// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/contact/route_agreement.hpp"

#include "edgeproof/contact/law/contact_law.hpp"
#include "edgeproof/contact/law/edge_expansion.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/quadrature/near_singularity.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

using namespace edgeproof::scenes;

namespace {

/// Returns the integral of f(s)/w(s) over the contact by s = c + d sin(theta) and panels between
/// the knots; it shares nothing with the kernels.
template <class F> Real over_w(const SlopeIn<Real>& slope, const Extent<Real>& e, const F& f) {
    const Real c = (e.a - e.b) / 2;
    const Real d = (e.a + e.b) / 2;
    std::vector<Real> theta{Real(-pi<Real>() / 2)};
    for (const Real& knot : slope.knots()) {
        if (knot < e.a && -knot < e.b) {
            theta.push_back(Real(asin((knot - c) / d)));
        }
    }
    theta.push_back(Real(pi<Real>() / 2));
    Real sum = 0;
    for (std::size_t i = 0; i + 1 < theta.size(); ++i) {
        const Real span = theta[i + 1] - theta[i];
        sum += span * tanh_sinh<Real>([&](const Real& lo, const Real&) {
                          const Real s = c + d * sin(Real(theta[i] + span * lo));
                          // A node may round onto its own knot; the panel's middle determines the
                          // piece.
                          const Real middle = c + d * sin(Real(theta[i] + span / 2));
                          return Real(slope.value(slope.piece_at(middle), s) * f(s));
                      }).value;
    }
    return sum;
}

std::vector<Contact> everything() {
    std::vector<Contact> all = symmetric();
    for (const Contact& c : tilted()) {
        all.push_back(c);
    }
    all.push_back(own_symmetric());
    return all;
}

} // namespace

TEST_CASE("consistency, force and moment against their integrals as printed") {
    // moore-hills.tex eqn:Consistency and eqn:AppliedNormalForce_NonSym, by another quadrature.
    for (const Contact& c : everything()) {
        CAPTURE(c.name);
        const NormalContact contact(c.profile, c.modulus, c.load, 40);
        const PrecisionScope scope(70);
        const ContactLaw<Real> law(c.profile, c.modulus.to<Real>());
        const Extent<Real> e = law.extent(c.load.value.to<Real>());
        const Real E = c.modulus.to<Real>();
        if (c.name == "power-law m=1/2" || c.name == "power-law m=5/8") {
            continue; // |s|^m at its corner needs the distance, which this integral does not have
        }
        const Real zero = over_w(law.slope(), e, [](const Real&) { return Real(1); });
        const Real size = law.slope().value(law.slope().pieces().size() - 1, e.a);
        CHECK(abs(zero) < size * Real("1e-45"));
        const Real P = E / 2 * over_w(law.slope(), e, [](const Real& s) { return s; });
        CHECK(common_digits(contact.force(), P) >= 40);
        if (!c.profile.symmetric()) {
            const Real M = (e.b - e.a) * P / 2 + E / 2 * over_w(law.slope(), e, [](const Real& s) {
                                                     return Real(s * s);
                                                 });
            // Relative to P times a length: a contact within one arc has no moment at all.
            CHECK(abs(contact.moment() - M) < P * (e.a + e.b) * Real("1e-40"));
        }
    }
}

TEST_CASE("the tilted wedge: b = gamma a and P = E* phi sqrt(gamma) a") {
    // Derived by hand from the consistency condition: sin(theta_0) = -(1-gamma)/(1+gamma).
    for (const char* ratio : {"1/5", "4/5", "1e-12", "999999999/1000000000", "-1/3"}) {
        CAPTURE(ratio);
        const Exact phi = exact("pi/16");
        const Exact alpha(exact(ratio).expr() * phi.expr());
        const NormalContact contact(Profile::tilted_wedge(phi, alpha), exact("3"),
                                    Load::right_edge(exact("7/5")), 50);
        const PrecisionScope scope(110);
        const Real S = sin(pi<Real>() / 2 * exact(ratio).to<Real>());
        const Real gamma = (1 - S) / (1 + S);
        CHECK(common_digits(contact.b(), gamma * 7 / 5) >= 50);
        CHECK(common_digits(contact.force(), 3 * pi<Real>() / 16 * sqrt(gamma) * 7 / 5) >= 50);
        CHECK(common_digits(contact.left_edge_derivative(1), gamma) >= 50);
        CHECK(abs(contact.left_edge_derivative(2)) < Real("1e-50"));
        CHECK(common_digits(contact.force_derivative(1), 3 * pi<Real>() / 16 * sqrt(gamma)) >= 50);
    }
}

TEST_CASE("derivatives of the law against the law itself at complex of real steps") {
    // A Taylor polynomial of 25 terms must agree with the independently solved b and P.
    for (const Contact& c : tilted()) {
        CAPTURE(c.name);
        const PrecisionScope scope(80);
        const ContactLaw<Real> law(c.profile, c.modulus.to<Real>());
        const Real a = c.load.value.to<Real>();
        const Extent<Real> e = law.extent(a);
        const LawSeries<Real> series = law.series(e, 25);
        Real radius = a + e.b;
        for (const Real& knot : law.slope().knots()) {
            for (const Real& d : {Real(abs(a - knot)), Real(abs(e.b + knot))}) {
                radius = d < radius && d > 0 ? d : radius;
            }
        }
        const Real z = radius / 10000;
        const Extent<Real> nearby = law.extent(Real(a + z));
        Real b = 0;
        Real rate = 0;
        for (std::size_t k = 25; k-- > 0;) {
            b = b * z + series.b[k];
            rate = rate * z + series.force_rate[k];
        }
        CHECK(common_digits(b, nearby.b) >= 60);
        CHECK(common_digits(rate, law.force_rate(nearby)) >= 60);
        // P' is the derivative of P: its antiderivative gives the step of P from a to a + z.
        Real rise = 0;
        for (std::size_t k = 25; k-- > 0;) {
            rise = rise * z + series.force_rate[k] / Real(static_cast<int>(k + 1));
        }
        rise *= z;
        CHECK(common_digits(rise, law.force(nearby) - law.force(e)) >= 50);
    }
}

TEST_CASE("b(a) is inverted") {
    for (const Contact& c : tilted()) {
        CAPTURE(c.name);
        const PrecisionScope scope(60);
        const ContactLaw<Real> law(c.profile, c.modulus.to<Real>());
        const Real a = c.load.value.to<Real>();
        CHECK(common_digits(law.right_edge(law.left_edge(a)), a) >= 50);
        CHECK(common_digits(law.left_force_rate(law.extent(a)) * law.series(law.extent(a), 2).b[1],
                            law.force_rate(law.extent(a))) >= 50);
    }
}

TEST_CASE("a force gives back the width that it came from") {
    for (const Contact& c : everything()) {
        CAPTURE(c.name);
        const PrecisionScope scope(60);
        const ContactLaw<Real> law(c.profile, c.modulus.to<Real>());
        const Real a = c.load.value.to<Real>();
        const Real back = law.right_edge_for_force(law.force(law.extent(a)));
        // Near the flat, P ~ (a - t)^(3/2) R^-1 loses some of a's digits.
        CHECK(common_digits(back, a) >= 44);
    }
}

TEST_CASE("the left edge on a knot, and 1e-25 from it") {
    // The right edge a is found such that b is on the knot of the tilted punch where its flat
    // begins.
    const PrecisionScope scope(140);
    const Profile profile =
        Profile::tilted_flat_and_rounded(exact("pi/16"), exact("1"), exact("2"));
    const ContactLaw<Real> law(profile, Real(7) / 3);
    const Real knot = -law.slope().knots()[0];
    const Real a = law.right_edge(knot);
    const Extent<Real> on{a, knot};
    CHECK(law.left_edge_on_knot(on));
    CHECK_FALSE(law.right_edge_on_knot(on));
    const Real step("1e-25");
    const Extent<Real> inside{law.right_edge(Real(knot - step)), Real(knot - step)};
    // One-sided derivatives: those just inside the knot tend to those on it.
    const LawSeries<Real> at = law.series(on, 4);
    const LawSeries<Real> near = law.series(inside, 4);
    for (std::size_t k = 0; k < 3; ++k) {
        CHECK(abs(at.b[k] - near.b[k]) < abs(at.b[k]) * Real("1e-20"));
        CHECK(abs(at.force_rate[k] - near.force_rate[k]) < abs(at.force_rate[k]) * Real("1e-20"));
    }
    // Just outside, b'' depends on the piece beyond the knot (its root singularity) and differs.
    const Extent<Real> outside{law.right_edge(Real(knot + step)), Real(knot + step)};
    CHECK(abs(law.series(outside, 4).b[3] - at.b[3]) > abs(at.b[3]));
}

TEST_CASE("loads without a contact are refused") {
    CHECK_THROWS_AS((void)Profile::power_law(exact("1"), exact("-1/2")), InputError);
    CHECK_THROWS_AS((void)Profile::power_law(exact("0"), exact("1")), InputError);
    CHECK_THROWS_AS((void)Profile::flat_and_rounded(exact("-1"), exact("1")), InputError);
    CHECK_THROWS_AS((void)Profile::flat_and_rounded(exact("1"), exact("0")), InputError);
    CHECK_THROWS_AS((void)Profile::tilted_wedge(exact("pi/16"), exact("pi/16")), InputError);
    CHECK_THROWS_AS((void)Profile::tilted_wedge(exact("pi/16"), exact("-1")), InputError);
    const Symbols x{"x"};
    const auto refuse = [&](const char* text, const std::vector<Exact>& knots,
                            const std::vector<Expr>& slopes) {
        try {
            (void)Profile::piecewise(knots, slopes);
            FAIL("accepted: ", text);
        } catch (const InputError& e) {
            CHECK_MESSAGE(std::string(e.what()).find(text) != std::string::npos, e.what());
        }
    };
    refuse("decreases", {}, {parse("-x", x)});
    refuse("decreases", {exact("1")}, {parse("x", x), parse("x - 1/2", x)});
    refuse("decreases", {}, {parse("-sin(3*x)", x)});
    refuse("decreases", {exact("3/2")}, {parse("sin(3*x)", x), parse("x", x)});
    refuse("origin", {}, {parse("x - 1", x)});
    refuse("ascend", {exact("2"), exact("1")}, {parse("x", x), parse("x", x), parse("x", x)});
    refuse("one piece more", {exact("2")}, {parse("x", x)});
    // The left side has no slope: no b satisfies the consistency condition.
    const Profile half = Profile::piecewise({exact("0")}, {parse("0", x), parse("x", x)});
    CHECK_THROWS_AS(NormalContact(half, exact("1"), Load::right_edge(exact("1")), 30), DomainError);
    CHECK_THROWS_AS(NormalContact(Profile::power_law(exact("1"), exact("1")), exact("1"),
                                  Load::right_edge(exact("0")), 30),
                    InputError);
    CHECK_THROWS_AS(NormalContact(Profile::power_law(exact("1"), exact("1")), exact("-1"),
                                  Load::right_edge(exact("1")), 30),
                    InputError);
}

TEST_CASE("mirrored twice is the same contact") {
    for (const Contact& c : tilted()) {
        CAPTURE(c.name);
        const Profile mirror = c.profile.reflected();
        const PrecisionScope scope(60);
        const ContactLaw<Real> law(c.profile, Real(2));
        const ContactLaw<Real> reflected(mirror, Real(2));
        const ContactLaw<Real> twice(mirror.reflected(), Real(2));
        const Extent<Real> e = law.extent(c.load.value.to<Real>());
        CHECK(common_digits(reflected.right_edge(e.a), e.b) >= 50);
        CHECK(common_digits(twice.left_edge(e.a), e.b) >= 50);
        CHECK(common_digits(-reflected.moment({e.b, e.a}), law.moment(e)) >= 48);
    }
}

TEST_CASE("Hertz: the binomial series") {
    // p = (E*/2R) sqrt(2a u) sqrt(1 - u/2a): c_k = (E* C/2) sqrt(2a) binom(1/2, k) (-1/2a)^k.
    const NormalContact contact(Profile::power_law(exact("1/70"), exact("1")), exact("7/3"),
                                Load::right_edge(exact("0.02")), 50);
    const std::vector<Real> c = contact.expansion(Edge::right, 42);
    const PrecisionScope scope(60);
    const Real a = Real(1) / 50;
    Real expected = Real(7) / 3 / 70 / 2 * sqrt(2 * a);
    for (int k = 0; k < 42; ++k) {
        CHECK(common_digits(c[static_cast<std::size_t>(k)], expected) >= 50);
        expected *= (Real(1) / 2 - k) / (k + 1) / (-2 * a);
    }
}

TEST_CASE("the wedge: the series of an inverse hyperbolic cosine") {
    // The coefficients of arcosh(1/(1-v)), v = u/a, from its derivative 1/((1-v) sqrt(v(2-v))): an
    // exact product of two known series.
    const NormalContact contact(Profile::power_law(exact("0.3"), exact("0")), exact("7/3"),
                                Load::right_edge(exact("3/2")), 50);
    const std::vector<Real> c = contact.expansion(Edge::right, 42);
    const PrecisionScope scope(70);
    const Real a = Real(3) / 2;
    std::vector<Real> root{Real(1)}; // (1 - v/2)^(-1/2)
    for (int k = 1; k < 42; ++k) {
        root.push_back(root.back() * (2 * k - 1) / (4 * k));
    }
    Real partial = 0; // times 1/(1 - v): partial sums
    Real power = 1;
    for (int k = 0; k < 42; ++k) {
        partial += root[static_cast<std::size_t>(k)];
        const Real expected = Real(7) / 10 / pi<Real>() * partial / sqrt(Real(2)) /
                              (k + Real(1) / 2) / (sqrt(a) * power);
        CHECK(common_digits(c[static_cast<std::size_t>(k)], expected) >= 50);
        power *= a;
    }
}

TEST_CASE("the left edge by its own derivation and by reflection: 40 terms") {
    for (const Contact& c : tilted()) {
        CAPTURE(c.name);
        const NormalContact contact(c.profile, c.modulus, c.load, 50);
        const std::vector<Real> own = contact.expansion(Edge::left, 40);
        const PrecisionScope scope(160);
        const ContactLaw<Real> law(c.profile, c.modulus.to<Real>());
        const Real b = law.left_edge(c.load.value.to<Real>());
        const ContactLaw<Real> mirror(c.profile.reflected(), c.modulus.to<Real>());
        const std::vector<Real> reflected =
            edge_expansion(mirror, mirror.extent(b), Edge::right, 40);
        REQUIRE(own.size() == 40);
        for (std::size_t k = 0; k < 40; ++k) {
            CHECK(common_digits(own[k], reflected[k]) >= 50);
        }
    }
}

TEST_CASE("the series sums to the pressure of another route inside its radius") {
    std::vector<Contact> contacts = symmetric();
    for (const Contact& c : tilted()) {
        contacts.push_back(c);
    }
    contacts.push_back(own_symmetric());
    for (const Contact& c : contacts) {
        CAPTURE(c.name);
        const NormalContact contact(c.profile, c.modulus, c.load, 40);
        for (const Edge edge : {Edge::right, Edge::left}) {
            const std::vector<Real> coefficients = contact.expansion(edge, 20);
            const PrecisionScope scope(60);
            const Real u = contact.convergence_radius(edge) / 1000;
            Real sum = 0;
            for (std::size_t k = 20; k-- > 0;) {
                sum = sum * u + coefficients[k];
            }
            sum *= sqrt(u);
            CHECK(common_digits(sum, contact.pressure(edge, u, Route::singular_integral).value) >=
                  40);
        }
    }
}

TEST_CASE("no terms are computed if none are requested") {
    const NormalContact contact(Profile::power_law(exact("1"), exact("1")), exact("1"),
                                Load::right_edge(exact("1")), 30);
    CHECK(contact.expansion(Edge::right, 0).empty());
    CHECK(contact.expansion(Edge::left, 1).size() == 1);
}
