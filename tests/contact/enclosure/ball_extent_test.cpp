// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/precision/error.hpp"
#include "tests/contact/extents.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

using namespace edgeproof::scenes;

TEST_CASE("by pressures of the witness, the error is the tolerance at crossings and less before "
          "the exit") {
    const auto unit = Load::right_edge(exact("1"));
    const std::vector<AskedExtent> all = {
        {Profile::flat_and_rounded(exact("2/5"), exact("1")), unit, Edge::right, 1, "1/100"},
        {Profile::flat_and_rounded(exact("4/5"), exact("1")), unit, Edge::right, 3, "1/100"},
        {Profile::flat_and_rounded(exact("1"), exact("1")), Load::right_edge(exact("1 + 1e-20")),
         Edge::right, 1, "1/100"},
        {Profile::power_law(exact("1"), exact("0")), unit, Edge::right, 2, "1/10"},
        {Profile::power_law(exact("1"), exact("5/8")), unit, Edge::right, 2, "1/100"},
        {Profile::power_law(exact("1"), exact("10")), unit, Edge::right, 3, "1/50"},
        {Profile::tilted_wedge(exact("pi/16"), exact("pi/20")), unit, Edge::right, 2, "1/100"},
        {Profile::tilted_flat_and_rounded(exact("pi/16"), exact("1"), exact("2")),
         Load::right_edge(exact("3")), Edge::right, 2, "1/20"},
        {Profile::tilted_wedge(exact("pi/16"), exact("pi/20")), Load::force(exact("1/10")),
         Edge::right, 1, "1e-9"}};
    for (AskedExtent asked : all) {
        for (const Edge edge : {Edge::right, Edge::left}) {
            CAPTURE(asked.profile.kind_name());
            CAPTURE(std::string(asked.tolerance));
            asked.edge = edge;
            const EnclosedExtents balls = enclosed<BallContact>(asked);
            CHECK(fault_by_witness(asked, balls) == "");
            CHECK(balls.first_exit.relative_accuracy_bits() > 166);
            CHECK(balls.measure.relative_accuracy_bits() > 166);
        }
    }
}

TEST_CASE("a corner too faint to see is a crossing at its place; a touch is left undecided") {
    // The logarithm matters only within e^(-10^6) of the corner.
    const auto ask = [](const Profile& profile, std::size_t n, const char* tolerance,
                        ExtentRange range) {
        return enclosed<BallContact>(
            {profile, Load::right_edge(exact("1")), Edge::right, n, tolerance, std::move(range)});
    };
    const Profile faint = curve("0", "x - 1e-9; x + 1e-9");
    const ExtentRange most{exact("0"), exact("3/4")};
    const EnclosedExtents e = ask(faint, 40, "1/100", most);
    CHECK(e.measure.lower() > 1);
    REQUIRE(e.crossings.size() >= 2);
    const auto is_one = [](const Ball& x) {
        return contains(x, Rational(1)) && x.relative_accuracy_bits() > 166;
    };
    CHECK(is_one(e.crossings[0]));
    CHECK(is_one(e.crossings[1]));
    // One term is above the tolerance on both sides of the corner; its error goes to -1 and back,
    // four times.
    const EnclosedExtents above = ask(faint, 1, "1/100", most);
    REQUIRE(above.crossings.size() == 5);
    CHECK(certainly_less(above.crossings[0], Ball(1, 400) / 20));
    CHECK(is_one(above.crossings[1]));
    CHECK(is_one(above.crossings[4]));
    CHECK(overlaps(above.measure, above.first_exit));
    // Hertz, one term, with the tolerance that its error reaches at 3/4 of the contact, the end of
    // the range.
    const Profile hertz = Profile::power_law(exact("1"), exact("1"));
    CHECK_THROWS_AS((void)ask(hertz, 1, "1", most), BudgetError);
    const Ball exit = ask(hertz, 1, "1", {}).first_exit;
    CHECK(contains(exit, Rational(3, 2)));
    CHECK(exit.relative_accuracy_bits() > 166);
}

// The value by mpmath at 70 digits is a row of tests/scene/values.txt.
TEST_CASE("two equal maxima: the peak is still enclosed, and narrower with more bits") {
    const Profile pad = Profile::flat_and_rounded(exact("0.4"), exact("3"));
    const Load load = Load::right_edge(exact("1.5"));
    Real last = 1;
    for (const long bits : {128L, 256L, 512L}) {
        const BallContact contact(pad, exact("2.1e11"), load, bits);
        const Ball peak = enclosed_peak(contact, true);
        const Real width = peak.radius() / peak.midpoint();
        CHECK(width < last * Real("1e-25"));
        last = width;
        const Ball either = enclosed_peak(contact, false);
        CHECK(overlaps(either, peak));
        CHECK(either.radius() < peak.midpoint() * Real("1e-15"));
    }
}
