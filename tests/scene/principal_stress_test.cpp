// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/scene/scene.hpp"
#include "tests/scene/traction_integrals.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

using scene::Body, scene::Quantity, scene::Scene, scenes::real_of;

namespace {

/// A contact with shear, with the Poisson's ratio of both bodies.
struct StressedContact {
    const char* profile;
    const char* load; ///< the rest of the scene
    const char* nu;
};

const StressedContact stressed_contacts[] = {
    {"kind = \"hertz\"\nR = \"2\"", "P = \"1\"", "0.3"},
    {"kind = \"tilted-wedge\"\nphi = \"1/3\"\nalpha = \"1/10\"",
     "P = \"1\"\n[shear]\nQ = \"0.3\"\nbulk_tension = \"0.02\"\nbulk_A = \"-0.1\"", "1/2"},
    {"kind = \"flat-and-rounded\"\nt = \"0.4\"\nR = \"1\"",
     "P = \"1\"\n[shear]\nQ = \"-0.3\"\nfriction = \"1/2\"\nbulk_tension = \"0.02\"\nbulk_A = "
     "\"0.2\"",
     "0.1"},
    {"kind = \"tilted-flat-and-rounded\"\nalpha = \"1/10\"\nt = \"0.4\"\nR = \"2\"",
     "P = \"1\"\n[shear]\nQ = \"0.3\"\nfriction = \"1/2\"\nbulk_tension = \"-0.01\"", "0"},
    {"kind = \"power-law\"\nm = \"5/2\"\nC = \"1/3\"",
     "[shear]\nfriction = \"1/2\"\n[[step]]\nP = \"3/4\"\nQ = \"1/4\"\n[[step]]\nP = \"1\"\n"
     "[[step]]\nQ = \"-0.4\"\n[[step]]\nP = \"0.9\"\nQ = \"0.1\"",
     "0.45"},
    {"kind = \"power-law\"\nm = \"5/2\"\nC = \"1/3\"",
     "P = \"1\"\n[shear]\nQ = \"-0.3\"\nfriction = \"1/2\"\nbulk_tension = \"0.02\"", "0.3"},
    {"kind = \"piecewise\"\nknots = [\"0\"]\nslopes = [\"x\", \"sinh(x)/2\"]",
     "P = \"1\"\n[shear]\nQ = \"0.3\"\nfriction = \"1/2\"\nbulk_tension = \"0.02\"", "0.3"},
};

Scene stressed_scene(const StressedContact& c) {
    const std::string load = std::string("contact_modulus = \"3/2\"\nnu = \"") + c.nu + "\"\n";
    return scene::parse_scene(std::string("[profile]\n") + c.profile + "\n[load]\n" + load +
                                  c.load + "\n[ask]\ndigits = 30\n",
                              "scene.toml");
}

/// The eigenvalues, in descending order, of a symmetric matrix of three rows, by Jacobi's
/// rotations.
std::array<Real, 3> eigenvalues(std::array<std::array<Real, 3>, 3> A) {
    for (int sweep = 0; sweep < 12; ++sweep) {
        for (const auto& [p, q] : {std::pair<std::size_t, std::size_t>{0, 1}, {0, 2}, {1, 2}}) {
            if (A[p][q] == 0) {
                continue;
            }
            const Real tau = (A[q][q] - A[p][p]) / (2 * A[p][q]);
            const Real sign = tau < 0 ? Real(-1) : Real(1);
            const Real t = sign / (abs(tau) + sqrt(Real(1 + tau * tau)));
            const Real c = 1 / sqrt(Real(1 + t * t));
            const Real s = t * c;
            for (std::size_t k = 0; k < 3; ++k) {
                const Real x = A[k][p];
                A[k][p] = c * x - s * A[k][q];
                A[k][q] = s * x + c * A[k][q];
            }
            for (std::size_t k = 0; k < 3; ++k) {
                const Real x = A[p][k];
                A[p][k] = c * x - s * A[q][k];
                A[q][k] = s * x + c * A[q][k];
            }
        }
    }
    std::array<Real, 3> values{A[0][0], A[1][1], A[2][2]};
    std::sort(values.begin(), values.end(), [](const Real& x, const Real& y) { return x > y; });
    return values;
}

} // namespace

// Both bodies, tilts, tension, full stick, partial slip and a load history: the components by
// quadrature, and the principal stresses as the eigenvalues of the matrix.
TEST_CASE("stresses of scenes agree with integrals of the tractions and with eigenvalues" *
          doctest::test_suite("slow")) {
    const PrecisionScope precision(34);
    std::mt19937_64 dice(20261125);
    std::uniform_real_distribution<double> across(-2.5, 2.5);
    std::uniform_real_distribution<double> decades(-1.5, 1);
    for (const StressedContact& contact : stressed_contacts) {
        CAPTURE(std::string(contact.profile));
        Scene s = stressed_scene(contact);
        scenes::TractionIntegrals integrals(s, 18);
        s.ask.quantities = {scene::QuantityGroup::stress};
        for (int i = 0; i < 4; ++i) {
            const Body body = i % 2 == 0 ? Body::A : Body::B;
            const std::string x = std::to_string(across(dice));
            const std::string z = std::to_string(std::pow(10, decades(dice)));
            s.ask.in_bodies.push_back({Exact::parse(x), Exact::parse(z), body});
        }
        const scene::SceneResult result = run_scene(s);
        const auto places = result.at_places(scene::QuantityRow::Place::body);
        REQUIRE(places.size() == 4);
        for (std::size_t i = 0; i < 4; ++i) {
            CAPTURE(i);
            const scene::BodyPoint& point = s.ask.in_bodies[i];
            const auto value = [&](Quantity quantity) {
                CHECK(places[i].at(quantity).proved);
                return real_of(places[i].at(quantity).value);
            };
            const Real nu = Exact::parse(contact.nu).to<Real>();
            const Real sxx = value(Quantity::sxx);
            const Real szz = value(Quantity::szz);
            const Real sxz = value(Quantity::sxz);
            const Real syy = nu * (sxx + szz); // no strain across the plane
            const auto by_matrix =
                eigenvalues({{{sxx, Real(0), sxz}, {Real(0), syy, Real(0)}, {sxz, Real(0), szz}}});
            const auto agree = [&](Quantity quantity, const Real& expected) {
                CAPTURE(value(quantity).str(20));
                CAPTURE(expected.str(20));
                CHECK(abs(Real(value(quantity) - expected)) < Real("1e-27"));
            };
            const long side = point.body == Body::A ? 1 : -1;
            const auto by_quadrature =
                integrals.at(point.x.to<Real>(), point.z.to<Real>(), side, 11, true);
            Real bulk(0);
            if (s.shear) {
                bulk = s.shear->bulk_A.to<Real>();
                bulk += side < 0 ? s.shear->bulk_tension.to<Real>() : Real(0);
            }
            CHECK(abs(Real(sxx - bulk - by_quadrature[0])) < Real("1e-8"));
            CHECK(abs(Real(szz - by_quadrature[1])) < Real("1e-8"));
            CHECK(abs(Real(sxz - by_quadrature[2])) < Real("1e-8"));
            agree(Quantity::syy, syy);
            agree(Quantity::s1, by_matrix[0]);
            agree(Quantity::s2, by_matrix[1]);
            agree(Quantity::s3, by_matrix[2]);
            agree(Quantity::tresca, Real(by_matrix[0] - by_matrix[2]));
        }
    }
}
