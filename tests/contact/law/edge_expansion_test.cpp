// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/contact/route_agreement.hpp"

#include "edgeproof/contact/law/edge_expansion.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

using namespace edgeproof::scenes;

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
