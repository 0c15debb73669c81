// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/contact/scenes.hpp"

#include "edgeproof/contact/batch/real_power.hpp"
#include "edgeproof/quadrature/holomorphic_reach.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace edgeproof::scenes;

TEST_CASE("powers by roots and by logarithms are MPFR's") {
    for (const unsigned digits : {30U, 75U, 300U}) {
        const PrecisionScope scope(digits);
        const Real tolerance = pow(Real(10), 2 - static_cast<int>(digits));
        for (const char* e :
             {"-1/4", "1/3", "-63/200", "5", "0", "-7", "17/16", "-5/8192", "12345/7", "pi/4"}) {
            CAPTURE(e);
            RealPower power(exact(e));
            const Real exponent = exact(e).to<Real>();
            for (const char* text : {"1", "0.3", "1e-7", "1e-400", "123.456"}) {
                CAPTURE(text);
                const Real x(text);
                Real found;
                power(found, x);
                const Real expected = pow(x, exponent);
                CHECK(abs(found - expected) <=
                      tolerance * expected * (1 + abs(exponent)) * (1 + abs(log(x))));
            }
        }
    }
}

TEST_CASE("how far a function is holomorphic: never beyond a pole, and far where there is none") {
    const auto reach = [](const ComplexFunction& f, double most) {
        return holomorphic_reach(f, 0.5, 0.5, most, -120);
    };
    const auto entire = reach([](acb_t out, const acb_t z) { acb_exp(out, z, 64); }, 1e9);
    REQUIRE(entire);
    CHECK(entire->ellipse.rho >= 6);
    // The bound is at most exp at the rightmost point, and at least exp at the leftmost.
    const double rightmost = 1 + entire->ellipse.excess();
    CHECK(entire->ln_bound >= rightmost - 1e-6);
    CHECK(entire->ln_bound <= rightmost + 0.5);
    const auto pole = reach(
        [](acb_t out, const acb_t z) {
            acb_sub_ui(out, z, 2, 64);
            acb_inv(out, out, 64);
        },
        1e9);
    REQUIRE(pole);
    CHECK(pole->ellipse.excess() < 1);
    CHECK(pole->ellipse.excess() > 0.3);
    CHECK(pole->ln_bound >= -std::log(1 - pole->ellipse.excess()) - 1e-6);
    // The square near the pole may be nearer to it than the ellipse, by its own side.
    CHECK(pole->ln_bound <= -std::log(1 - pole->ellipse.excess()) + std::log(3.0));
    const auto limited = reach([](acb_t out, const acb_t z) { acb_exp(out, z, 64); }, 0.1);
    REQUIRE(limited);
    CHECK(limited->ellipse.excess() <= 0.1);
    CHECK_FALSE(reach(
        [](acb_t out, const acb_t z) {
            if (arb_contains_zero(acb_imagref(z)) != 0 &&
                arb_contains_nonpositive(acb_realref(z)) != 0) {
                acb_indeterminate(out);
            } else {
                acb_sqrt(out, z, 64);
            }
        },
        1e9));
}
