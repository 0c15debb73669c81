// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/comparison/self_test.hpp"

#include "edgeproof/comparison/comparison.hpp"
#include "edgeproof/comparison/measures/measures.hpp"
#include "edgeproof/comparison/spring_bed.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

namespace {

void check_named(const SelfTest& test) {
    for (const std::string& miss : test.misses) {
        MESSAGE(miss);
    }
    const SelfTestCount sum = test.total();
    CHECK(sum.wrong == 0);
    CHECK(sum.cases > 10);
    CHECK(100 * sum.named >= 95 * sum.cases);
    CHECK(test.passes());
}

} // namespace

TEST_CASE("self-test: mistakes in shear are named, and none wrongly") {
    const SelfTest test = run_self_test(5, {"two cylinders, full stick"});
    check_named(test);
    const auto tension = std::ranges::find(test.rows, "sign-of-tension", &SelfTestRow::name);
    REQUIRE(tension != test.rows.end());
    CHECK(tension->at[2].named == 1);
}

TEST_CASE("self-test: mistakes in the pressure are named, and none wrongly") {
    const SelfTest test =
        run_self_test(5, {"two cylinders, unlike materials", "a wedge under P and M"});
    check_named(test);
    const auto right = std::ranges::find(test.rows, "", &SelfTestRow::name);
    REQUIRE(right != test.rows.end());
    for (std::size_t level = 0; level < noise_levels.size(); ++level) {
        CHECK(right->at[level].named == 10); // no cause at any noise: right data, and four waves
    }
    // If a moment tilts a wedge, its angle is that of the punch.
    const auto angle = std::ranges::find(test.rows, "tangent-of-angle", &SelfTestRow::name);
    REQUIRE(angle != test.rows.end());
    CHECK(angle->at[0].named == 1);
}

TEST_CASE("the allowance for a mesh by a corner is that of boundary elements with rigid springs") {
    constexpr double elements = 200; // in the contact
    double greatest = 0;
    int count = 0;
    for (const TestedContact& tested : tested_contacts()) {
        const Scene scene = scene_of(tested.keys);
        const ExactContact exact(scene);
        if (!exact.scale().mean || exact.axisymmetric()) {
            continue;
        }
        ++count;
        const SpringBed rigid(scene, exact, 0);
        double products = 0;
        double squares = 0;
        for (int i = 0; i < 400; ++i) {
            const double x = -exact.b().value + exact.length() * (i + 0.37) / 400;
            const auto at = exact.at(x);
            const double zone = 2 * exact.length() / 100; // two elements of 100 in the contact
            const bool near_corner = std::ranges::any_of(exact.knots(), [&](const auto& knot) {
                return knot.corner && std::abs(x - knot.x) < zone;
            });
            if (at.p && at.u() > zone && !near_corner) {
                products += rigid.pressure(x) * *at.p;
                squares += *at.p * *at.p;
            }
        }
        CAPTURE(tested.name);
        CAPTURE(elements * std::abs(products / squares - 1));
        greatest = std::max(greatest, elements * std::abs(products / squares - 1));
    }
    CHECK(count >= 2);
    CHECK(greatest <= mesh_error_by_corner_times_elements);
    CHECK(greatest > 0.75 * mesh_error_by_corner_times_elements); // and not much more
}

// The apex of a wedge is a corner, where the noise of one node has the effect of a small shift.
TEST_CASE("self-test: places from the middle of a wedge are named under noise") {
    check_named(run_self_test(424243, {"a wedge under P and M"}));
}

// docs/compare.md prints the last line of this table.
TEST_CASE("self-test: mistakes in all contacts are named, and none wrongly" *
          doctest::test_suite("slow")) {
    const SelfTest test = run_self_test(1);
    MESSAGE(test.text());
    CHECK(test.total().wrong == 0);
    CHECK(test.passes());
}

TEST_CASE("self-test: it fails where a cause is missed, and where a wrong one is named") {
    SelfTest test;
    CHECK_FALSE(test.passes()); // no mistake was tried
    SelfTestRow row{"a", {}};
    row.at[0] = {20, 19, 19, 3, 0};
    test.rows.push_back(row);
    CHECK(test.passes());
    test.rows[0].at[1] = {1, 0, 0, 0, 0};
    CHECK_FALSE(test.passes());
    test.rows[0].at[1] = {40, 40, 40, 0, 1};
    CHECK_FALSE(test.passes());
    test.rows[0].at[1] = {40, 40, 40, 0, 0};
    SelfTestRow right{"", {}};
    right.at[2] = {3, 3, 3, 0, 0};
    test.rows.push_back(right);
    CHECK(test.passes());
    CHECK(test.total().cases == 60);
    test.rows[1].at[2] = {3, 2, 2, 0, 1};
    CHECK_FALSE(test.passes());
}

TEST_CASE("self-test: each mistake has a contact that it makes sense in") {
    for (const InjectedMistake& mistake : injected_mistakes()) {
        CAPTURE(mistake.name);
        CHECK(std::ranges::any_of(tested_contacts(), [&](const TestedContact& contact) {
            return contact.keys.contains("shear.Q") == mistake.of_shear &&
                   mistake.make(contact.keys).has_value();
        }));
    }
}
