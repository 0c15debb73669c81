// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/checks/parts/residual_fit.hpp"
#include "edgeproof/contact/curved/proved_slip.hpp"
#include "edgeproof/precision/error.hpp"
#include "tests/contact/scenes.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

using namespace edgeproof::scenes;

namespace {

const ResidualFitOptions fit_options;

std::unique_ptr<ProvedContact> enclosed_contact(const Contact& c) {
    return proved_contact(c.profile, c.modulus, c.load, fit_options.bits());
}

/// The slopes must be n + 1/2, or n + 3/2 for n = `vanishing`.
void check_slopes(const std::vector<Real>& slopes, std::size_t vanishing = 8) {
    const PrecisionScope scope(60);
    REQUIRE(slopes.size() == 8);
    for (std::size_t n = 0; n < slopes.size(); ++n) {
        CAPTURE(n);
        const Real order = Real(static_cast<int>(n)) + Real(1) / 2 + (n == vanishing ? 1 : 0);
        CHECK(abs(slopes[n] - order) < Real("1e-10"));
    }
}

} // namespace

TEST_CASE("residual fit: orders 1/2 to 15/2 at symmetric edges and at both edges of others") {
    const auto contacts = symmetric();
    for (const std::size_t i : {0U, 1U, 3U, 4U, 6U, 8U}) {
        CAPTURE(contacts[i].name);
        // At m = 5/8 the second coefficient vanishes.
        check_slopes(fit_residuals(*enclosed_contact(contacts[i]), Edge::right, fit_options).slopes,
                     i == 3 ? 1 : 8);
    }
    const auto others = tilted();
    for (const std::size_t i : {0U, 3U, 4U, 5U}) {
        CAPTURE(others[i].name);
        const auto contact = enclosed_contact(others[i]);
        check_slopes(fit_residuals(*contact, Edge::right, fit_options).slopes);
        check_slopes(fit_residuals(*contact, Edge::left, fit_options).slopes);
    }
}

TEST_CASE("residual fit: after a wrong coefficient the residual keeps its order") {
    const auto contact = enclosed_contact(symmetric()[6]);
    std::vector<Ball> coefficients = contact->expansion(Edge::right, 8);
    coefficients[2] *= Ball(Rational(11, 10), fit_options.bits());
    const auto slopes = fit_residuals(*contact, Edge::right, fit_options, coefficients).slopes;
    const PrecisionScope scope(60);
    for (const auto& [n, order] : {std::pair{1, "1.5"}, {2, "2.5"}, {3, "2.5"}, {7, "2.5"}}) {
        CAPTURE(n);
        CHECK(abs(slopes[static_cast<std::size_t>(n)] - Real(order)) < Real("1e-10"));
    }
}

TEST_CASE("residual fit: input that cannot be fitted is refused") {
    const auto contact = enclosed_contact(symmetric()[6]);
    CHECK_THROWS_AS((void)fit_residuals(*contact, Edge::right, {.points = 2}), DomainError);
    CHECK_THROWS_AS((void)fit_residuals(*contact, Edge::right, {}, std::vector<Ball>{Ball(1, 64)}),
                    DomainError);
}
