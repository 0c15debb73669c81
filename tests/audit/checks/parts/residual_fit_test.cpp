// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/checks/parts/residual_fit.hpp"
#include "edgeproof/precision/error.hpp"
#include "tests/contact/scenes.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

using namespace edgeproof::scenes;

namespace {

void expect_confirmed(const Contact& c, Edge edge) {
    CAPTURE(c.name);
    const auto fits = fit_residuals(c.profile, c.modulus, c.load, edge);
    REQUIRE(fits.size() == 8);
    const PrecisionScope scope(60);
    for (const OrderFit& fit : fits) {
        CAPTURE(fit.n);
        CHECK(fit.confirmed);
        CHECK(fit.agreeing_digits >= 45);
        const Real order = Real(static_cast<int>(fit.n)) + Real(1) / 2 + (fit.vanishing ? 1 : 0);
        CHECK(abs(fit.slope - order) < Real("1e-10"));
    }
}

} // namespace

TEST_CASE("residual fit: orders 1/2 to 15/2 and their coefficients, symmetric") {
    const auto contacts = symmetric();
    for (const std::size_t i : {0U, 1U, 3U, 4U, 6U, 8U}) {
        expect_confirmed(contacts[i], Edge::right);
    }
}

TEST_CASE("residual fit: both edges of tilted contacts") {
    const auto contacts = tilted();
    for (const std::size_t i : {0U, 3U, 4U, 5U}) {
        expect_confirmed(contacts[i], Edge::right);
        expect_confirmed(contacts[i], Edge::left);
    }
}

TEST_CASE("residual fit: at m = 5/8 the second coefficient vanishes, and this is reported") {
    const Contact c = symmetric()[3];
    const auto fits = fit_residuals(c.profile, c.modulus, c.load, Edge::right);
    for (const OrderFit& fit : fits) {
        CHECK(fit.vanishing == (fit.n == 1));
    }
}

TEST_CASE("residual fit: a wrong coefficient is found, at its order and after it") {
    const Contact c = symmetric()[6];
    std::vector<Real> coefficients;
    {
        const NormalContact contact(c.profile, c.modulus, c.load, 120);
        coefficients = contact.expansion(Edge::right, 8);
    }
    const PrecisionScope scope(130);
    coefficients[2] *= 1 + Real("1e-30"); // wrong in its 31st digit
    const auto fits = fit_residuals(c.profile, c.modulus, c.load, Edge::right, {}, coefficients);
    CHECK(fits[0].confirmed);
    CHECK(fits[1].confirmed);
    CHECK_FALSE(fits[2].confirmed);
    CHECK(fits[2].agreeing_digits == 30);
    CHECK_FALSE(fits[3].confirmed);
    // With an error of a tenth, the residual keeps the order of the wrong term: 5/2, not 7/2.
    coefficients[2] *= Real(11) / 10;
    const auto worse = fit_residuals(c.profile, c.modulus, c.load, Edge::right, {}, coefficients);
    CHECK(abs(worse[3].slope - Real(5) / 2) < Real("1e-10"));
    CHECK_FALSE(worse[3].confirmed);
}

TEST_CASE("residual fit: evidence from Barber-Mossakovskii is the same") {
    const Contact c = symmetric()[6];
    const auto fits = fit_residuals(c.profile, c.modulus, c.load, Edge::right,
                                    {.orders = 3, .route = Route::barber_mossakovskii});
    for (const OrderFit& fit : fits) {
        CHECK(fit.confirmed);
    }
}

TEST_CASE("residual fit: input that cannot be fitted is refused") {
    const Contact c = symmetric()[6];
    CHECK_THROWS_AS((void)fit_residuals(c.profile, c.modulus, c.load, Edge::right, {.points = 2}),
                    DomainError);
    CHECK_THROWS_AS((void)fit_residuals(c.profile, c.modulus, c.load, Edge::right, {},
                                        std::vector<Real>{Real(1)}),
                    DomainError);
}
