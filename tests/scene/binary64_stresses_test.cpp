// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/scene/binary64_values.hpp"

#include "edgeproof/precision/double_word/binary64_ball.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/real.hpp"
#include "tests/scene/scene_words.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <vector>

using scene::Body, scene::Scene;

namespace {

/// The arrays of the stresses of a scene at points.
struct StressMap {
    std::vector<double> x;
    std::vector<double> z;
    std::array<std::vector<double>, scene::binary64_stresses.size()> of;
    std::vector<double> bound;

    void compute(const Scene& s, Body body, unsigned threads = 1) {
        of.fill(std::vector<double>(x.size(), -1));
        bound.assign(x.size(), -1);
        compute_binary64(s, body, x, z, {{of[0], of[1], of[2], of[3], of[4]}, bound}, threads);
    }
};

const std::string slipping_pad =
    "flat-and-rounded t=0.4 R=1 a=1 E=2 nu=0.3 Q=-1/10 friction=0.6 bulk_A=0.1";

const std::vector<std::string> mapped_contacts{
    "hertz R=1 a=1 E=2 nu=0.3",
    slipping_pad,
    slipping_pad + " bulk_tension=0.02",
    "flat-and-rounded t=0.999 R=1 a=1 E=2 nu=0.3 Q=1/9",
    "tilted-wedge phi=1/3 alpha=1/10 a=1 E=2 nu=0.3 Q=0.3 bulk_tension=0.2",
    "tilted-flat-and-rounded alpha=1/10 t=0.4 R=2 a=1 E=2 nu=0.3 Q=0.1 path=together",
    "power-law m=5/2 C=1 a=1 E=2 nu=0.3 Q=0.1 friction=0.6",
    "hertz R=1 a=1 E=2 nu=0.3 friction=0.6 sliding=left bulk_tension=0.1",
    "sphere R=1 a=1 E=2 nu=0.3",
    "cone phi=1/5 a=1 E=2 nu=0.3",
};

} // namespace

TEST_CASE("binary64 with bounds: sums, products, roots, logarithms and angles") {
    std::mt19937_64 dice(7);
    std::uniform_real_distribution<double> unit(-1, 1);
    constexpr long bits = 200;
    const auto drawn = [&] { return unit(dice) * std::exp2(20 * unit(dice)); };
    const auto ball = [](double x) { return Ball(exact_rational(x), bits); };
    const auto holds = [&](const Binary64Ball& found, const Ball& exact, double most) {
        CHECK(abs(Ball(exact - ball(found.middle))).upper() <= Real(found.radius));
        CHECK(found.radius <= most);
    };
    for (int i = 0; i < 3000; ++i) {
        const double x = drawn();
        const double y = drawn();
        const double r = std::fabs(drawn()) * 1e-13;
        const double X = x + r * unit(dice) / 2; // a number of the ball
        const Binary64Ball of_x{x, r};
        const Binary64Ball of_y{y, 0};
        const double size = std::fabs(x) + std::fabs(y);
        holds(of_x + of_y, ball(X) + ball(y), r + 1e-15 * size);
        holds(of_x * of_y, ball(X) * ball(y), 2 * r * size + 1e-15 * std::fabs(x * y));
        holds(of_x / of_y, ball(X) / ball(y), HUGE_VAL);
        const double least = std::fabs(x) - r;
        if (least > 0) {
            const Binary64Ball of_size{std::fabs(x), r};
            holds(sqrt(of_size), sqrt(ball(std::fabs(X))), std::sqrt(r) + 1e-15 * std::sqrt(size));
            holds(log(of_size), log(ball(std::fabs(X))), 1e-13 + 2 * r / least);
            holds(sqrt(Binary64Ball{std::fabs(x), 0}), sqrt(ball(std::fabs(x))),
                  2e-16 * std::sqrt(std::fabs(x)));
        }
        holds(log(Binary64Ball{std::fabs(y), 0}), log(ball(std::fabs(y))), 1e-13);
        holds(atan2(of_y, Binary64Ball{x, 0}), atan2(ball(y), ball(x)), 1e-14);
        holds(atan2(Binary64Ball{std::fabs(y) * 1e-20, 0}, Binary64Ball{std::fabs(x), 0}),
              atan2(ball(std::fabs(y) * 1e-20), ball(std::fabs(x))),
              1e-34 * std::fabs(y / x) + 1e-290);
        const Binary64Ball wide = atan2(of_y, of_x);
        CHECK(
            (!std::isfinite(wide.radius) ||
             abs(Ball(atan2(ball(y), ball(X)) - ball(wide.middle))).upper() <= Real(wide.radius)));
    }
    CHECK_FALSE(std::isfinite(atan2(Binary64Ball{1e-20, 1e-19}, Binary64Ball{-1, 0}).radius));
    CHECK_FALSE(std::isfinite(atan2(Binary64Ball{}, Binary64Ball{}).radius));
    CHECK_FALSE(std::isfinite(log(Binary64Ball{1, 1}).radius));
    CHECK(sqrt(Binary64Ball{-1e-30, 2e-30}).radius >= 1e-15);
}

// The values of run_scene are compared with quadratures in relations_test.cpp.
TEST_CASE("maps of stresses: the bounds hold, near edges, knots and far away as well") {
    std::mt19937_64 dice(20261126);
    std::uniform_real_distribution<double> unit(-1, 1);
    for (const std::string& contact : mapped_contacts) {
        CAPTURE(contact);
        const Scene s = scenes::made(contact);
        StressMap map;
        for (int i = 0; i < 30; ++i) {
            const double middle = i % 3 == 0 ? 1.0 : i % 3 == 1 ? 0.4 : 0.0;
            map.x.push_back(middle + std::copysign(std::exp2(-25 + 25 * unit(dice)), unit(dice)));
            map.z.push_back(i % 5 == 0 ? 0 : std::exp2(-20 + 24 * unit(dice)));
        }
        for (const Body body : {Body::A, Body::B}) {
            map.compute(s, body);
            Scene asked = s;
            asked.ask.digits = {25, Rounding::nearest, false};
            asked.ask.quantities = {scene::QuantityGroup::stress};
            asked.ask.in_bodies.clear();
            for (std::size_t i = 0; i < map.x.size(); ++i) {
                asked.ask.in_bodies.push_back({Exact::of(exact_rational(map.x[i])),
                                               Exact::of(exact_rational(map.z[i])), body});
            }
            const scene::SceneResult result = run_scene(asked);
            for (const auto& at : result.at_places(scene::QuantityRow::Place::body)) {
                const std::size_t i = at.point();
                CAPTURE(map.x[i]);
                CAPTURE(map.z[i]);
                double most = 0;
                for (std::size_t k = 0; k < map.of.size(); ++k) {
                    const double found = map.of.at(k)[i];
                    const Ball error = abs(Ball(at.at(scene::binary64_stresses.at(k)).value -
                                                Ball(exact_rational(found), 200)));
                    CHECK(error.upper() <= Real(map.bound[i]) + Real("1e-24"));
                    most += k == 3 ? 0 : std::fabs(found); // tau_max is less than the others
                }
                CHECK(map.bound[i] <= 1e-12 + 0x1p-53 * most);
            }
        }
    }
}

TEST_CASE("maps of stresses: knots, threads, and points that are refused") {
    const Scene s = scenes::made(slipping_pad);
    StressMap map;
    for (int i = 0; i < 10'000; ++i) {
        map.x.push_back(-2 + 4 * (i % 100) / 99.0);
        map.z.push_back((i / 100) / 50.0);
    }
    map.x[0] = 0.4; // nearest to the knot, and the edge itself
    map.x[1] = 1;
    map.z[0] = map.z[1] = 0;
    map.compute(s, Body::A);
    StressMap other = map;
    other.compute(s, Body::A, 2);
    CHECK(map.of == other.of);
    CHECK(map.bound == other.bound);
    CHECK(map.of[1][1] == 0); // szz
    map.z[5] = -1;
    CHECK_THROWS_WITH_AS(map.compute(s, Body::A), doctest::Contains("negative"), InputError);
    map.z[5] = NAN;
    CHECK_THROWS_AS(map.compute(s, Body::A), DomainError);
    StressMap edge;
    edge.x = {1};
    edge.z = {0};
    CHECK_THROWS_AS(edge.compute(scenes::made("hertz R=1 a=1 E=2 nu=0.3 Q=1"), Body::A),
                    InputError);
}
