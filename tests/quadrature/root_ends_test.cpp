// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/precision/error.hpp"
#include "edgeproof/quadrature/near_singularity.hpp"
#include "tests/support/namespaces.hpp"

#include <boost/math/constants/constants.hpp>
#include <doctest/doctest.h>

namespace {

Real the_pi() { return boost::math::constants::pi<Real>(); }

bool agrees(const std::optional<QuadratureResult<Real>>& found, const Real& right) {
    return found && found->converged &&
           abs(Real(found->value - right)) <=
               abs(right) * pow(Real(10), 3 - static_cast<int>(working_digits()));
}

} // namespace

// The exact values are elementary integrals, by their antiderivatives.
TEST_CASE("root ends: roots of every order at either end, at three precisions") {
    for (const unsigned digits : {30U, 70U, 400U}) {
        CAPTURE(digits);
        const PrecisionScope scope(digits);
        const Real zero(0);
        const auto whole = [&](const auto& f, const Real& length) {
            return integrate_root_ends(f, length, zero, zero);
        };
        CHECK(agrees(
            whole([](const Real& r, const Real& rest) { return Real(1 / sqrt(Real(r * rest))); },
                  Real(3)),
            the_pi()));
        CHECK(
            agrees(whole([](const Real& r, const Real& rest) { return Real(sqrt(Real(r * rest))); },
                         Real(1)),
                   Real(the_pi() / 8)));
        CHECK(agrees(whole([](const Real& r, const Real&) { return Real(r * r); }, Real(1)),
                     Real(Real(1) / 3)));
        // For e^r/sqrt(rest), which has no short antiderivative: r = 1 - t^2, and the series of
        // e^(-t^2).
        const auto found = whole(
            [](const Real& r, const Real& rest) { return Real(exp(r) / sqrt(rest)); }, Real(1));
        CHECK(agrees(found,
                     Real(exp(Real(1)) * sqrt(the_pi()) * boost::multiprecision::erf(Real(1)))));
    }
}

TEST_CASE("root ends: another root beyond an end, however near") {
    const PrecisionScope scope(60);
    for (const int exponent : {-1, -2, -6, -15, -40}) {
        CAPTURE(exponent);
        const Real beyond = pow(Real(10), exponent);
        const Real right = 2 * asinh(sqrt(Real(1 / beyond)));
        CHECK(agrees(
            integrate_root_ends(
                [&](const Real& r, const Real&) { return Real(1 / sqrt(Real(r * (r + beyond)))); },
                Real(1), beyond, Real(0)),
            right));
        CHECK(agrees(integrate_root_ends(
                         [&](const Real&, const Real& rest) {
                             return Real(1 / sqrt(Real(rest * (rest + beyond))));
                         },
                         Real(1), Real(0), beyond),
                     right));
        // Both ends: the density of the arc sine over a part of its range, with exact distances
        // from the ends.
        CHECK(agrees(integrate_root_ends(
                         [&](const Real& r, const Real& rest) {
                             return Real(1 / sqrt(Real((r + beyond) * (rest + beyond))));
                         },
                         Real(1), beyond, beyond),
                     Real(the_pi() - 4 * asin(sqrt(Real(beyond / (1 + 2 * beyond)))))));
    }
}

TEST_CASE("root ends: an end that is not a root, or an interior that is not smooth, is left to "
          "another rule") {
    const PrecisionScope scope(70);
    std::size_t calls = 0;
    const auto converges = [&](const auto& f) {
        calls = 0;
        const auto counted = [&](const Real& r, const Real& rest) {
            ++calls;
            return Real(f(r, rest));
        };
        return integrate_root_ends(counted, Real(1), Real(0), Real(0)).has_value();
    };
    CHECK_FALSE(converges([](const Real& r, const Real&) { return log(r); }));
    CHECK(calls == 47); // 10 + 15 + 22
    CHECK_FALSE(converges([](const Real& r, const Real&) { return Real(r * log(r)); }));
    CHECK_FALSE(converges([](const Real& r, const Real&) { return cbrt(r); }));
    CHECK_FALSE(converges([](const Real& r, const Real&) { return Real(1 / r); }));
    CHECK_FALSE(converges([](const Real& r, const Real&) { return Real(3 * r < 1 ? 1 : 0); }));
    CHECK_FALSE(converges([](const Real& r, const Real&) { return abs(Real(r - Real(1) / 3)); }));
    CHECK_FALSE(converges([](const Real& r, const Real&) { return Real(r + 1e-30 * log(r)); }));
    for (int exponent = -42; exponent < 0; exponent += 3) {
        CAPTURE(exponent);
        const Real factor = pow(Real(10), exponent);
        CHECK_FALSE(converges([&](const Real& r, const Real&) {
            return Real(1 / (2 + r) + factor * r * log(r)); // the factor hides it from small rules
        }));
    }
    CHECK(converges([](const Real& r, const Real&) { return Real(1 / (1 + r)); }));
    CHECK_THROWS_AS((void)converges([](const Real& r, const Real&) { return log(Real(-r)); }),
                    DomainError);
}

TEST_CASE("root ends: the numbers of nodes, and an estimate that is not smaller than the error") {
    struct Case {
        unsigned digits;
        std::size_t nodes;
    };
    // Recorded numbers; a different number means that the rule has changed.
    for (const Case& c : {Case{30, 106}, Case{70, 169}, Case{200, 481}}) {
        CAPTURE(c.digits);
        const PrecisionScope scope(c.digits);
        const auto found = integrate_root_ends(
            [](const Real& r, const Real&) { return Real(1 / sqrt(Real(r * (r + 2)))); }, Real(1),
            Real(2), Real(0));
        REQUIRE(found.has_value());
        CHECK(found->evaluations == c.nodes);
        const Real right = 2 * asinh(sqrt(Real(Real(1) / 2)));
        CHECK(abs(Real(found->value - right)) <=
              right * (found->estimate + pow(Real(10), 3 - static_cast<int>(c.digits))));
    }
}
