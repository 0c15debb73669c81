// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/sample/naive_integral.hpp"
#include "edgeproof/precision/error.hpp"
#include "tests/support/namespaces.hpp"

#include <boost/math/constants/constants.hpp>

#include <doctest/doctest.h>

namespace {

constexpr unsigned naive_digits = 40;
const NaivePrecision precision{.nodes = naive_digits};

bool agrees(const NaiveIntegral& found, const Real& right) {
    const PrecisionScope scope(naive_digits);
    return found.converged && abs(Real(found.value - right)) < abs(right) * pow(Real(10), -30);
}

} // namespace

// The values are elementary integrals, computed from antiderivatives.
TEST_CASE("an integrand as it stands: singular ends of every power that has an integral") {
    const PrecisionScope scope(3 * naive_digits);
    const Real zero(0);
    const Real one(1);
    const Real pi = boost::math::constants::pi<Real>();
    CHECK(agrees(integrate_naively([](const Real& s) { return Real(1 / sqrt(Real(1 - s * s))); },
                                   Real(-1), one, {}, precision),
                 pi));
    CHECK(agrees(
        integrate_naively([](const Real& s) { return Real(log(s)); }, zero, one, {}, precision),
        Real(-1)));
    CHECK(agrees(
        integrate_naively([](const Real& s) { return Real(exp(s)); }, one, zero, {}, precision),
        Real(1 - exp(one))));
}

TEST_CASE("an integrand that grows like one over the distance, or faster, has no value") {
    const PrecisionScope scope(3 * naive_digits);
    const auto thrown = [&](const NaiveIntegrand& f) {
        CHECK_THROWS_AS((void)integrate_naively(f, Real(-1), Real(1), {}, precision), DomainError);
    };
    thrown([](const Real& s) { return Real(1 / (1 - s * s)); });
    thrown([](const Real& s) { return Real(1 / (1 - s)); });
    thrown([](const Real& s) { return Real(pow(Real(1 + s), -2)); });
    thrown([](const Real& s) { return Real(pow(Real(1 + s), Real(-3) / 2)); });
}

TEST_CASE("an integrand with a jump inside does not converge, and is not called divergent") {
    const PrecisionScope scope(3 * naive_digits);
    const Real third = Real(1) / 3;
    std::size_t calls = 0;
    const NaiveIntegrand kinked = [&](const Real& s) {
        ++calls;
        return Real(s < third ? 1 : 0);
    };
    const NaiveIntegral found = integrate_naively(kinked, Real(0), Real(1), {}, precision);
    CHECK_FALSE(found.converged);
    CHECK(calls < 20000); // the last level alone has ten times as many
    CHECK(agrees(integrate_naively(kinked, Real(0), Real(1), {third}, precision), third));
}
