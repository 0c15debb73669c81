// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/contact/enclosure/interval_maximum.hpp"
#include "edgeproof/precision/error.hpp"
#include "tests/contact/extents.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

using namespace edgeproof::scenes;

TEST_CASE("by pressures of the witness, the error is the tolerance at crossings and less before "
          "the exit") {
    const std::string wedge = "tilted-wedge phi=pi/16 alpha=pi/20 ";
    const std::vector<AskedExtent> all = {
        {contact_of("flat-and-rounded t=2/5 R=1 a=1"), Edge::right, 1, "1/100"},
        {contact_of("flat-and-rounded t=4/5 R=1 a=1"), Edge::right, 3, "1/100"},
        {contact_of("flat-and-rounded t=1 R=1 a=1+1e-20"), Edge::right, 1, "1/100"},
        {contact_of("power-law m=0 C=1 a=1"), Edge::right, 2, "1/10"},
        {contact_of("power-law m=5/8 C=1 a=1"), Edge::right, 2, "1/100"},
        {contact_of("power-law m=10 C=1 a=1"), Edge::right, 3, "1/50"},
        {contact_of(wedge + "a=1"), Edge::right, 2, "1/100"},
        {contact_of("tilted-flat-and-rounded alpha=pi/16 t=1 R=2 a=3"), Edge::right, 2, "1/20"},
        {contact_of(wedge + "P=1/10"), Edge::right, 1, "1e-9"}};
    for (AskedExtent asked : all) {
        for (const Edge edge : {Edge::right, Edge::left}) {
            CAPTURE(asked.contact.name);
            CAPTURE(asked.tolerance);
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
    const auto ask = [](const std::string& words, std::size_t n, const char* tolerance,
                        ExtentRange range) {
        return enclosed<BallContact>(
            {contact_of(words), Edge::right, n, tolerance, std::move(range)});
    };
    const std::string faint = "piecewise knots=0 slopes=x-1e-9;x+1e-9 a=1";
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
    const std::string hertz = "power-law m=1 C=1 a=1";
    CHECK_THROWS_AS((void)ask(hertz, 1, "1", most), BudgetError);
    const Ball exit = ask(hertz, 1, "1", {}).first_exit;
    CHECK(contains(exit, Rational(3, 2)));
    CHECK(exit.relative_accuracy_bits() > 166);
}

// The value by mpmath at 70 digits is a row of tests/scene/values.txt.
TEST_CASE("two equal maxima: the peak is still enclosed, and narrower with more bits") {
    const Contact pad = contact_of("flat-and-rounded t=0.4 R=3 a=1.5 E=2.1e11");
    Real last = 1;
    for (const long bits : {128L, 256L, 512L}) {
        const BallContact contact(pad.profile, pad.modulus, pad.load, bits);
        const Ball peak = enclosed_peak(contact, true);
        const Real width = peak.radius() / peak.midpoint();
        CHECK(width < last * Real("1e-25"));
        last = width;
        const Ball either = enclosed_peak(contact, false);
        CHECK(overlaps(either, peak));
        CHECK(either.radius() < peak.midpoint() * Real("1e-15"));
    }
}
