// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/report/figures/scene_figure.hpp"

#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace {

std::vector<Plot> picture_of_scene(const std::string& profile, const std::string& ask) {
    return scene_picture(scene::parse_scene("[profile]\n" + profile +
                                                "[load]\na = 1\ncontact_modulus = 1\n[ask]\n" + ask,
                                            "scene.toml"),
                         [](std::size_t done, std::size_t of) { REQUIRE(done <= of); });
}

/// The pressure of a rounded punch with a flat of half-width t, for a = E* = R = 1, by the integral
/// of `barber2002` (Moore and Hills, Eq. (21), without the factor a): the sum over w with
/// s^2 = x^2 + w^2, at the middles of steps that are dense where s = t.
double rounded_punch(double x, double t) {
    constexpr int steps = 400;
    const double low = std::sqrt(std::max(std::max(x * x, t * t) - x * x, 0.0));
    const double high = std::sqrt(1 - x * x);
    double sum = 0;
    for (int k = 0; k < steps; ++k) {
        const double y = (k + 0.5) / steps;
        const double w = low + (high - low) * y * y;
        const double s = std::max(std::sqrt(x * x + w * w), t);
        sum += (std::numbers::pi / 2 - std::asin(t / s)) * 2 * y * (high - low) / steps;
    }
    return sum / std::numbers::pi;
}

/// The greatest distance of a polygon from a curve, between the places of the polygon.
template <class F> double off(const Plot& plot, const F& exact) {
    double worst = 0;
    const std::vector<Real>* before = nullptr;
    std::vector<std::vector<Real>> drawn;
    for (const auto& row : plot.rows) {
        if (row[1]) {
            drawn.push_back({*row[0], *row[1]});
        }
    }
    for (const auto& point : drawn) {
        for (int j = 1; before != nullptr && j < 8; ++j) {
            const double part = j / 8.0;
            const double x0 = (*before)[0].convert_to<double>();
            const double x1 = point[0].convert_to<double>();
            const double p0 = (*before)[1].convert_to<double>();
            const double p1 = point[1].convert_to<double>();
            worst =
                std::max(worst, std::fabs(p0 + (p1 - p0) * part - exact(x0 + (x1 - x0) * part)));
        }
        before = &point;
    }
    return worst;
}

} // namespace

// With 122 places that are even in the angle, the polygon is off by 2.4 % of the peak for t = 0.9.
TEST_CASE("plot: the curve is smooth at a narrow peak, and has few places where it is smooth") {
    const double t = 0.9;
    const double peak = rounded_punch(0.905, t); // 0.0387, within 1 % of the greatest pressure
    const std::vector<Plot> picture = picture_of_scene(
        "kind = \"flat-and-rounded\"\nt = \"0.9\"\nR = 1\n", "terms = [1]\ntolerance = \"1%\"\n");
    const Plot& plot = picture.front();
    CHECK(off(plot, [&](double x) { return rounded_punch(x, t); }) < peak / 300);
    REQUIRE(plot.y.range);
    CHECK(plot.y.range->second.convert_to<double>() > peak);
    CHECK(plot.y.range->second.convert_to<double>() < 1.3 * peak);
    const std::vector<Plot> hertz =
        picture_of_scene("kind = \"hertz\"\nR = 1\n", "terms = [1]\ntolerance = \"1%\"\n");
    CHECK(off(hertz.front(), [](double x) { return std::sqrt(1 - x * x) / 2; }) < 0.5 / 300);
    CHECK(hertz.front().rows.size() < 150);
}

TEST_CASE("plot: an infinite pressure at a corner ends the steps, and the range shows the rest") {
    // p = arcosh(1/|x|)/pi for g' = +-1 and a = E* = 1: infinite at x = 0.
    const std::vector<Plot> picture = picture_of_scene(
        "kind = \"tilted-wedge\"\nphi = 1\nalpha = 0\n", "terms = [1]\ntolerance = \"1%\"\n");
    const Plot& plot = picture.front();
    CHECK(plot.rows.size() < 400);
    const double top = plot.y.range->second.convert_to<double>();
    CHECK(top > std::acosh(10) / std::numbers::pi);
    CHECK(top < std::acosh(1e9) / std::numbers::pi);
}

TEST_CASE("plot: errors in percent, up to the other edge and no farther") {
    const std::vector<Plot> picture =
        picture_of_scene("kind = \"hertz\"\nR = 1\n", "terms = [1]\ntolerance = \"1/100\"\n");
    const Plot& plot = picture.back();
    REQUIRE(plot.x.range);
    CHECK(plot.x.range->second.convert_to<double>() == 2); // a + b
    CHECK(plot.y.percent);
    CHECK(plot.y.label.ends_with("[%]"));
    REQUIRE(plot.level);
    CHECK(plot.level->first == 1);
    CHECK(plot.level->second == "tolerance 1 %");
}
