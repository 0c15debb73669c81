// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/validation/honesty.hpp"
#include "lab/validation/plain_tanh_sinh.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

namespace {

std::vector<HonestyPoint> of_profile(const std::string& name, const std::string& regime) {
    std::vector<HonestyPoint> list;
    for (HonestyPoint& p : honesty_points()) {
        if (p.profile == name && p.regime == regime) {
            list.push_back(std::move(p));
        }
    }
    return list;
}

const HonestyRow& row_of(const std::vector<HonestyRow>& rows, const std::string& route) {
    for (const HonestyRow& r : rows) {
        if (r.route == route) {
            return r;
        }
    }
    throw std::runtime_error("no row of " + route);
}

} // namespace

TEST_CASE(
    "honesty: our bounds hold; plain tanh-sinh understates at the edge; a false claim is caught") {
    const auto points = of_profile("Hertz", "u < a"); // p = sqrt(u (2 - u))/2
    REQUIRE(points.size() == 3);
    const PrecisionScope scope(60);
    ClaimedValues liar;
    for (const HonestyPoint& p : points) {
        const Real u = p.u.to<Real>();
        const Real exact = sqrt(Real(u * (2 - u))) / 2;
        liar[p.id] = {Real(exact + pow(Real(10), -20)), pow(Real(10), -23)};
    }
    const auto rows = honesty(points, {{"liar", liar}}, {.digits = 30});
    CHECK(row_of(rows, "Barber-Mossakovskii").understated == 0);
    CHECK(row_of(rows, "Barber-Mossakovskii").least_right >= 30);
    CHECK(row_of(rows, "singular integral").understated == 0);
    CHECK(row_of(rows, "liar").understated == 3);
    CHECK(row_of(rows, "liar").worst_ratio == doctest::Approx(3).epsilon(1e-6));
    CHECK(row_of(rows, "liar").least_right == 19);
    // Half of the digits are lost in x + node, which the integrator does not know.
    CHECK(row_of(rows, "plain Boost, double").least_right < 12);
}

TEST_CASE("honesty: at every number of digits, each point has a value or none" *
          doctest::test_suite("slow")) {
    // u from 1e-30 to 1/2 at 5 ... 60 digits: x = a - u from far below roundoff to far above it,
    // where the plain integrator distinguishes only some of its nodes from the ends.
    std::vector<HonestyPoint> points;
    for (HonestyPoint& p : honesty_points()) {
        if (p.profile == "Hertz" || p.profile == "wedge" || p.profile == "tilted wedge") {
            points.push_back(std::move(p));
        }
    }
    REQUIRE(points.size() == 36);
    for (unsigned digits = 5; digits <= 60; digits += digits < 40 ? 5 : 10) {
        CAPTURE(digits);
        const auto rows = honesty(points, {}, {.digits = digits});
        CHECK(rows.size() == 48); // 4 routes, 3 profiles, 4 regimes
        for (const HonestyRow& row : rows) {
            CAPTURE(row.route);
            CHECK(row.points == 3);
            const bool ours =
                row.route == "Barber-Mossakovskii" || row.route == "singular integral";
            CHECK((!ours || (row.none == 0 && row.understated == 0)));
        }
    }
}

TEST_CASE("honesty: plain tanh-sinh over intervals of a few units of the last place") {
    // The integral of 1/sqrt((s - x)(1 - s)) is pi for every x.
    for (const unsigned digits : {5U, 6U, 8U, 10U, 20U, 30U}) {
        const PrecisionScope scope(digits);
        for (unsigned k = digits - 2; k <= digits + 2; ++k) {
            CAPTURE(digits);
            CAPTURE(k);
            const Real x = 1 - pow(Real(10), -static_cast<int>(k));
            const auto f = [&](const Real& s) { return Real(1 / sqrt(Real((s - x) * (1 - s)))); };
            try {
                const auto r = plain_tanh_sinh<Real>(f, x, Real(1));
                CHECK((!isfinite(r.value) || r.value < 10)); // some value, even if it is bad
            } catch (const std::exception&) {
                CHECK(k >= digits - 2); // it reports that it has none
            }
        }
    }
}

TEST_CASE("honesty: questions and answers of other programs") {
    const auto points = honesty_points();
    const std::string questions = integral_questions(points, 50);
    CHECK(questions.find("0 50 power 1.000") == 0);
    CHECK(questions.find(" flat ") != std::string::npos);
    const ClaimedValues answers = integral_answers("3 0.5 1e-20\nnoise\n4 x 1\n5 1 2 3\n");
    CHECK(answers.size() == 1);
    CHECK(answers.at("3").value == Real(1) / 2);
}
