// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/contact/enclosure/interval_maximum.hpp"
#include "edgeproof/precision/error.hpp"
#include "tests/contact/extents.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

using namespace edgeproof::scenes;

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
