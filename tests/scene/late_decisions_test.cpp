// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/precision/rounding/text.hpp"
#include "edgeproof/scene/scene.hpp"
#include "tests/scene/scene_text.hpp"

#include <doctest/doctest.h>

#include <string>

// Contacts whose values were refused, or took minutes, because a search decided late.
namespace {

/// The stick zone is a small wedge-like contact at the knot 0.
const char* const stick_zone_at_a_corner = R"toml([profile]
kind = "piecewise"
knots = ["-361/156250", "0", "9747/2500000"]
slopes = ["(10353/23750)*x - (-2092437/3125000000)", "0", "2871/6250000", "(12557/23750)*x - (581827/390625000)"]
[load]
contact_modulus = "631/100"
P = "4/390625"
[shear]
Q = "-261/25000000"
friction = "11/10"
bulk_tension = "1711/2500000"
)toml";

const char* const sharp_wedge = R"toml([profile]
kind = "wedge"
phi = "499/1000"
[load]
contact_modulus = "26900"
a = "93/25"
)toml";

/// With a = 1 the force is E* (pi/4 + (k - 1) (arccos(r)/2 - r sqrt(1 - r^2)/2)) for k = 2, r =
/// 1/2.
const char* const bilinear = R"toml([profile]
kind = "piecewise"
symmetric = true
knots = ["1/2"]
slopes = ["x", "2*x - 1/2"]
[load]
contact_modulus = "1"
P = "5*pi/12 - sqrt(3)/8"
)toml";

struct LateDecision {
    const char* scene;
    AskedValue asked;
    unsigned digits;
    const char* expected;
    const char* most_off;
};

} // namespace

TEST_CASE("contacts whose searches decide late have the values of other routes") {
    AskedValue six{Quantity::measure, 6};
    six.tolerance = Exact::of(1);
    AskedValue eight{Quantity::measure, 8};
    eight.tolerance = Exact::of(1);
    const LateDecision rows[] = {
        // mpmath, findroot of the conditions of both edges and of the force, 50 digits.
        {stick_zone_at_a_corner, {Quantity::a}, 32, "0.00267727351534354268189278602737", "1e-32"},
        {stick_zone_at_a_corner,
         {Quantity::stick_a},
         32,
         "0.00008956283869911484157956692832810068",
         "1e-34"},
        {stick_zone_at_a_corner,
         {Quantity::stick_b},
         32,
         "0.00231332196842267989898273504961864965",
         "1e-32"},
        // mpmath, findroot of |p_n/p - 1| = 1 with p = phi E*/pi arcosh(a/x).
        {sharp_wedge, six, 21, "4.4918927608171139755401360835", "1e-20"},
        {sharp_wedge, eight, 21, "4.3316916718996917169340966631", "1e-20"},
        {bilinear, {Quantity::a}, 600, "1", "1e-600"},
    };
    for (const LateDecision& row : rows) {
        CAPTURE(std::string(row.expected));
        SceneValues values(scenes::parsed(row.scene), {row.asked}, {row.digits});
        const BoundedValue value = values.value(row.asked);
        CHECK(value.proved);
        const Rational expected = parse_decimal(row.expected);
        const Rational most_off = parse_decimal(row.most_off);
        CHECK(certainly_less(abs(value.value - Ball(expected, 2048)), Ball(most_off, 2048)));
        CHECK(value.value.relative_accuracy_bits() > 3.3 * row.digits);
    }
}
