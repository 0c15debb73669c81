// SPDX-License-Identifier: BSD-3-Clause

#include "edgeproof/scene/binary64_values.hpp"
#include "tests/scene/scene_words.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <span>
#include <string>
#include <vector>

using scene::Body, scene::Quantity, scene::Scene;

TEST_CASE("stresses of a picture agree with proved ones at places that were not compared") {
    struct Drawn {
        std::string words;
        std::size_t compared;
    };
    const Drawn contacts[] = {
        {"sphere R=1 a=1 E=2 nu=0.3", 40},
        {"cone phi=1/5 a=1 E=2 nu=0.2", 40},
        {"axisymmetric power-law m=1/2 C=1 a=1 E=2 nu=0.3", 20},
        {"axisymmetric flat-and-rounded t=1/4 R=1 a=1 E=2 nu=0.3", 12},
        {"axisymmetric piecewise symmetric knots=1/2 slopes=x/2;x a=1 E=2 nu=0.3", 12},
        {"axisymmetric piecewise symmetric slopes=sinh(x) a=1 E=2 nu=0.3", 4},
        {"power-law m=3/2 C=1 a=1 E=2 nu=0.3 Q=0.06 friction=1/2 bulk_tension=1/200", 30},
        {"piecewise knots=0 slopes=x/2;x+x^3 a=1 E=2 nu=0.3 Q=1/9", 30},
        {"piecewise symmetric knots=1/3 slopes=x^3;1/27+x/3 P=1 E=2 nu=0.3", 30},
    };
    std::mt19937_64 dice(20261129);
    std::uniform_real_distribution<double> unit(-1, 1);
    for (const auto& contact : contacts) {
        const auto& words = contact.words;
        const auto compared = contact.compared;
        CAPTURE(words);
        const Scene s = scenes::made(words);
        std::vector<double> x;
        std::vector<double> z;
        for (std::size_t i = 0; i < 1000; ++i) {
            x.push_back(2 * unit(dice));
            z.push_back(0.01 + 1.5 * std::fabs(unit(dice)));
        }
        std::vector<std::vector<double>> exact(6, std::vector<double>(compared));
        const std::span<const double> some_x(x.data(), compared);
        const std::span<const double> some_z(z.data(), compared);
        compute_binary64(s, Body::A, some_x, some_z,
                         {exact[0], exact[1], exact[2], exact[3], exact[4], exact[5]});
        for (std::size_t q = 0; q < scene::binary64_stresses.size(); ++q) {
            const scene::PictureStresses found =
                picture_stresses(s, scene::binary64_stresses[q], Body::A, x, z);
            CHECK(found.estimates);
            double greatest = 0;
            for (const double value : found.values) {
                greatest = std::max(greatest, std::fabs(value));
            }
            for (std::size_t i = 0; i < compared; ++i) {
                CAPTURE(x[i]);
                CAPTURE(z[i]);
                CHECK(std::fabs(found.values[i] - exact[q][i]) <= 3e-4 * greatest);
            }
        }
    }
}
