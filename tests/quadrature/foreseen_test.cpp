// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/quadrature/tanh_sinh.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <functional>
#include <vector>

namespace {

/// An integrand over 0 < x < 1, as f(x, 1 - x), whose integral is known in closed form.
struct Known {
    const char* name;
    std::function<Real(const Real&, const Real&)> f;
    std::function<Real()> integral;
};

std::vector<Known> known_integrals() {
    return {
        {"1/sqrt(x (1 - x))", [](const Real& x, const Real& y) { return Real(1 / sqrt(x * y)); },
         [] { return pi<Real>(); }},
        {"log x / sqrt(1 - x)", [](const Real& x, const Real& y) { return Real(log(x) / sqrt(y)); },
         [] { return Real(4 * log(Real(2)) - 4); }},
        {"1/(x + 1/1000)", [](const Real& x, const Real&) { return Real(1000 / (1000 * x + 1)); },
         [] { return Real(log(Real(1001))); }},
        {"e^x", [](const Real& x, const Real&) { return Real(exp(x)); },
         [] { return Real(exp(Real(1)) - 1); }},
        {"cos 40 x", [](const Real& x, const Real&) { return Real(cos(40 * x)); },
         [] { return Real(sin(Real(40)) / 40); }},
    };
}

} // namespace

TEST_CASE("a level predicted to have the digits has them, before the next one shows it") {
    for (const unsigned digits : {34U, 70U, 130U}) {
        const PrecisionScope scope(digits);
        for (const Known& known : known_integrals()) {
            CAPTURE(digits);
            CAPTURE(std::string(known.name));
            const auto shown = tanh_sinh<Real>(known.f);
            const auto foreseen = tanh_sinh<Real>(known.f, {.foresees = true});
            REQUIRE(shown.converged);
            CHECK(foreseen.converged);
            CHECK(foreseen.evaluations <= shown.evaluations);
            const Real exact = known.integral();
            // For all of them, the integral of |f| is less than ten times 1 + |the integral of f|.
            const Real allowed = (1 + abs(exact)) * 1000 * unit_roundoff<Real>();
            CHECK(abs(foreseen.value - exact) < allowed);
        }
        std::size_t shown = 0;
        std::size_t foreseen = 0;
        for (const Known& known : known_integrals()) {
            shown += tanh_sinh<Real>(known.f).evaluations;
            foreseen += tanh_sinh<Real>(known.f, {.foresees = true}).evaluations;
        }
        CHECK(foreseen < shown);
    }
}

TEST_CASE("nothing is predicted for an integrand with a kink inside") {
    const PrecisionScope scope(40);
    const auto kinked = [](const Real& x, const Real&) { return Real(abs(x - Real(1) / 3)); };
    const auto r = tanh_sinh<Real>(kinked, {.last_level = 10, .foresees = true});
    const Real exact = Real(5) / 18;
    CHECK_FALSE(r.converged);
    CHECK(abs(r.value - exact) < 10 * r.estimate);
}
