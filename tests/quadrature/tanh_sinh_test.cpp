// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/precision/real.hpp"
#include "edgeproof/quadrature/tanh_sinh.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <vector>

namespace {

bool near(const Real& x, const Real& exact) {
    return abs(Real(x - exact)) <= 2000 * unit_roundoff<Real>() * abs(exact);
}

} // namespace

TEST_CASE("end-point singularities cost no digits") {
    for (const unsigned digits : {16U, 50U, 100U, 300U}) {
        CAPTURE(digits);
        const PrecisionScope scope(digits);
        // B(1/2, 1/2) = pi; the integral of ln(x)/sqrt(x) is -4; that of (x(1-x))^(3/2) is 3
        // pi/128.
        const auto r1 =
            tanh_sinh([](const Real& lo, const Real& hi) { return Real(1 / sqrt(Real(lo * hi))); });
        CHECK(r1.converged);
        CHECK(near(r1.value, pi<Real>()));
        const auto r2 =
            tanh_sinh([](const Real& lo, const Real&) { return Real(log(lo) / sqrt(lo)); });
        CHECK(near(r2.value, Real(-4)));
        const auto r3 = tanh_sinh([](const Real& lo, const Real& hi) {
            const Real z = lo * hi;
            return Real(z * sqrt(z));
        });
        CHECK(near(r3.value, Real(3 * pi<Real>() / 128)));
    }
}

TEST_CASE("the one-argument integrand loses half the digits: the reason for two distances") {
    const PrecisionScope scope(50);
    const auto careless = tanh_sinh([](const Real& lo, const Real& hi) {
        const Real x = 1 - hi;       // loses the distance from the right end ...
        const Real from_end = 1 - x; // ... which cannot be recovered
        return Real(1 / sqrt(from_end + (from_end == 0 ? hi : Real(0)) + 0 * lo));
    });
    const Real error = abs(careless.value - 2);
    CHECK(error > Real("1e-35"));
    CHECK(error < Real("1e-15"));
}

TEST_CASE("a singularity just outside is mapped away, however near") {
    const PrecisionScope scope(50);
    for (const char* text : {"0.1", "1e-5", "1e-20", "1e-100"}) {
        const Real d(text);
        // The integral of 1/sqrt(x (x + d)) over (0, 1) is 2 asinh(1/sqrt(d)).
        const Real exact = 2 * asinh(1 / sqrt(d));
        const auto f = [&](const Real& lo, const Real&) { return Real(1 / sqrt(lo * (lo + d))); };
        const auto right = integrate_near(f, Real(1), d, Real(0));
        CHECK(right.converged);
        CHECK(abs(right.value / exact - 1) < Real("1e-47"));
        const auto mirrored = integrate_near(
            [&](const Real& lo, const Real& hi) { return f(hi, lo); }, Real(1), Real(0), d);
        CHECK(abs(mirrored.value / exact - 1) < Real("1e-47"));
    }
    // Poles near both ends: the integral of 1/sqrt((x + d)(1 + d - x)) over (0, 1).
    const Real d("1e-12");
    const auto both = integrate_near(
        [&](const Real& lo, const Real& hi) { return Real(1 / sqrt((lo + d) * (hi + d))); },
        Real(1), d, d);
    CHECK(abs(both.value - 2 * asin(1 / (1 + 2 * d))) < Real("1e-47"));
}

TEST_CASE("a feature between the nodes is invisible: the reason for cutting at every knot") {
    const PrecisionScope scope(50);
    // sqrt|x - c| with c inside: full digits are never reached in one piece, but in two.
    const Real c = Real(1) / 3;
    const auto whole = tanh_sinh(
        [&](const Real& lo, const Real&) { return Real(sqrt(abs(lo - c))); }, {.last_level = 9});
    CHECK_FALSE(whole.converged);
    const std::vector<Real> lengths{c, Real(1 - c)};
    const auto cut = integrate_pieces(
        [&](std::size_t i, const Real& lo, const Real& hi) { return Real(sqrt(i == 0 ? hi : lo)); },
        lengths, Real(0), Real(0));
    CHECK(cut.converged);
    const Real exact = 2 * (c * sqrt(c) + (1 - c) * sqrt(1 - c)) / 3;
    CHECK(abs(cut.value - exact) < Real("1e-48"));
}

TEST_CASE("evaluations are counted, and an unexplained saving fails as well") {
    const PrecisionScope scope(50);
    std::size_t calls = 0;
    const auto r = tanh_sinh([&](const Real& lo, const Real& hi) {
        ++calls;
        return Real(1 / sqrt(lo * hi));
    });
    CHECK(r.evaluations == calls);
    CHECK(r.evaluations > 150);
    CHECK(r.evaluations < 400);
}
