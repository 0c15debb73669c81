// SPDX-License-Identifier: BSD-3-Clause
// values SCENE COUNT: pressures of bench/binary64/punch.toml (a = 1, t = 2/5, E* = R = 1) at COUNT
// places in a geometric sequence from u = 1e-16 to 1, in binary64: correctly rounded; by the
// textbook's formula in double; by Boost.Math's tanh-sinh in double, with the singularity removed
// by a substitution and 1 - x^2 computed from u. Writes a line for each place (u and the three
// values, in full), then `time` and the nanoseconds for a value of each. The contact is solved
// before.
#include "edgeproof/scene/binary64_values.hpp"

#include <boost/math/quadrature/tanh_sinh.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <numbers>
#include <vector>

namespace {

double seconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Returns (1/pi) times the integral of s acos(t/s)/sqrt(s^2 - x^2) over max(x, t) < s < 1, by the
/// substitution s^2 = x^2 + w^2, or s = t/cos(phi) for x < t.
double by_tanh_sinh(boost::math::quadrature::tanh_sinh<double>& rule, double u) {
    constexpr double t = 0.4;
    const double x = 1 - u;
    if (x < t) {
        const auto f = [&](double phi) {
            const double c = std::cos(phi);
            return phi * std::sin(phi) / (c * c * std::sqrt(t * t - x * x * c * c));
        };
        return t * t / std::numbers::pi * rule.integrate(f, 0.0, std::acos(t));
    }
    const auto f = [&](double w) { return std::acos(t / std::sqrt(x * x + w * w)); };
    return rule.integrate(f, 0.0, std::sqrt(u * (2 - u))) / std::numbers::pi;
}

/// The logarithmic sum of the textbook, x = 1 - u.
double by_textbook(double u) {
    constexpr double t = 0.4;
    const double x = 1 - u;
    const double w = std::sqrt((1 - x) * (1 + x));
    const auto green = [&](double s) {
        const double one = std::sqrt(std::abs((1 - x) * (1 + s)));
        const double other = std::sqrt(std::abs((1 - s) * (1 + x)));
        return std::log(std::abs((one + other) / (one - other)));
    };
    return (2 * w * std::acos(t) + (x - t) * green(t) - (x + t) * green(-t)) /
           (2 * std::numbers::pi);
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 3) {
        std::fputs("values SCENE COUNT\n", stderr);
        return 2;
    }
    using namespace edgeproof;
    const scene::Scene scene = scene::read_scene(argv[1]);
    const std::size_t count = std::strtoul(argv[2], nullptr, 10);
    const scene::Binary64Pressures rounded(scene);
    boost::math::quadrature::tanh_sinh<double> rule;
    const std::array<std::function<double(double)>, 3> ways{
        [&](double u) { return rounded(contact::Edge::right, u); },
        [&](double u) { return by_textbook(u); }, [&](double u) { return by_tanh_sinh(rule, u); }};
    std::vector<double> places(count);
    for (std::size_t i = 0; i < count; ++i) {
        places[i] =
            std::pow(10.0, -16 * (static_cast<double>(i) + 0.5) / static_cast<double>(count));
    }
    std::array<std::vector<double>, 3> p;
    std::array<double, 3> nanoseconds{};
    for (std::size_t k = 0; k < ways.size(); ++k) {
        std::vector<double> runs;
        for (int run = 0; run < 6; ++run) {
            p[k].clear();
            const double begun = seconds();
            for (const double u : places) {
                p[k].push_back(ways[k](u));
            }
            if (run > 0) { // the first run fills tables
                runs.push_back(seconds() - begun);
            }
        }
        std::ranges::sort(runs);
        nanoseconds[k] = 1e9 * runs[runs.size() / 2] / static_cast<double>(count);
    }
    for (std::size_t i = 0; i < count; ++i) {
        std::printf("%.17g %.17g %.17g %.17g\n", places[i], p[0][i], p[1][i], p[2][i]);
    }
    std::printf("time %.1f %.1f %.1f\n", nanoseconds[0], nanoseconds[1], nanoseconds[2]);
}
