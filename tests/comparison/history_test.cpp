// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/comparison/hertz_data.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

using namespace edgeproof::hertz_data;

namespace {

/// A Hertz contact with f = 0.5 and a = 1 under P = 1 (E*/R = 4/pi, Johnson, eq. 4.43). Q grows to
/// 0.315, then reverses to -0.1; at last P falls to 0.64, so that a = 0.8.
const std::string steps_scene = R"([profile]
kind = "hertz"
R = "1"
[load]
contact_modulus = "4/pi"
[shear]
friction = "0.5"
[[step]]
P = "1"
[[step]]
Q = "0.315"
[[step]]
Q = "-0.1"
[[step]]
P = "0.64"
Q = "0"
)";

/// p under the force L, for which a = sqrt(L).
double p_under(double L, double x) {
    return x * x < L ? 2 / std::numbers::pi * std::sqrt(L - x * x) : 0;
}
/// After Q = 0.315: f (p - p(L_s)) with f (1 - L_s) = 0.315 (Johnson, section 7.2).
double q_after_2(double x) { return 0.5 * (p_under(1, x) - p_under(0.37, x)); }
/// After Q = -0.1: the reversal adds -2 f (p - p(L_r)) with 2 f (1 - L_r) = 0.415 (Mindlin and
/// Deresiewicz; Johnson, section 7.4).
double q_after_3(double x) { return q_after_2(x) - (p_under(1, x) - p_under(0.585, x)); }
/// After P = 0.64, Q = 0: the layers above 0.64 are gone; -0.5 from 0.585 to 0.64, 0.5 from 0.37 to
/// 0.585. The force -0.5 * 0.055 + 0.5 * 0.215 = 0.08 is too large: the zone outside L_s slips,
/// with -0.5 from L_s, 0.5 from 0.37: L_s - 0.37 = 0.64 - L_s.
double q_after_4(double x) {
    return 0.5 * (2 * p_under(0.505, x) - p_under(0.37, x) - p_under(0.64, x));
}

std::string step_rows(double P, const std::function<double(double)>& q) {
    std::string text = "x,CPRESS,CSHEAR1\n";
    for (const double x : even_places(-1.2, 1.2, 96)) {
        text += number(x) + "," + number(p_under(P, x)) + "," + number(q(x)) + "\n";
    }
    return text;
}

FileComparison after_step(std::size_t step, const std::string& rows) {
    Scene scene = parse_scene(steps_scene, "s.toml");
    set_step(scene, step);
    Tolerances t;
    t.pressure = 1e-8;
    t.zone = parse_edge_zone("0.001");
    return Diagnosed(scene).of(rows, t);
}

} // namespace

TEST_CASE("steps: the shear traction of Hertz by superposition, after each step") {
    const auto right = [](std::size_t step, double P, const std::function<double(double)>& q) {
        CAPTURE(step);
        const FileComparison file = after_step(step, step_rows(P, q));
        CHECK_MESSAGE(file.passes(), file.failures[0]);
        REQUIRE(file.shear);
        CHECK(file.shear->nodes > 60);
        CHECK(file.shear->peak < 1e-9);
    };
    right(2, 1, q_after_2);
    right(3, 1, q_after_3);
    right(4, 0.64, q_after_4);
}

TEST_CASE("steps: the mistakes in a load history are named") {
    const auto named = [](const std::string& cause, const std::string& rows) {
        CAPTURE(cause);
        const FileComparison file = after_step(3, rows);
        CHECK_FALSE(file.passes());
        CHECK(is_named(file.shear_diagnosis, cause));
    };
    named("another-step", step_rows(1, q_after_2));
    // P = 1, then Q = -0.1 at once: f (1 - L_s) = 0.1.
    named("no-history",
          step_rows(1, [](double x) { return -0.5 * (p_under(1, x) - p_under(0.8, x)); }));
    // Half of each Q: f (1 - L_s) = 0.1575, then 2 f (1 - L_r) = 0.2075.
    named("half-shear-force", step_rows(1, [](double x) {
              return 0.5 * (p_under(1, x) - p_under(0.685, x)) -
                     (p_under(1, x) - p_under(0.7925, x));
          }));
}
