// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/evidence/honesty.hpp"

#include <doctest/doctest.h>

using namespace edgeproof;

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
    "honesty: ours hold; plain tanh-sinh understates at the edge; a made-up claim is caught") {
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
    // Half of the digits are lost to x + node, which the integrator is not told.
    CHECK(row_of(rows, "plain Boost, double").least_right < 12);
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
