// SPDX-License-Identifier: BSD-3-Clause
#include "tests/contact/by_witness.hpp"

#include "edgeproof/contact/curved/proved_slip.hpp"
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/split_mix.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <future>

using namespace edgeproof::scenes;

namespace {

constexpr Route both_routes[] = {Route::singular_integral, Route::barber_mossakovskii};

Contact drawn(SplitMix64& dice) {
    const auto number = [&](std::size_t least, std::size_t most) {
        return std::to_string(least + dice.below(most - least + 1));
    };
    const std::string a = " a=" + number(3, 40) + "/10";
    const std::string load = dice.next() % 2 == 0 ? a : " P=" + number(1, 99) + "/50";
    switch (dice.next() % 5) {
    case 0:
        return contact_of("power-law C=1/7 m=" + number(1, 60) + "/12" + load);
    case 1:
        return contact_of("flat-and-rounded R=3 t=" + number(1, 20) + "/70" + load);
    case 2:
        return contact_of("tilted-wedge phi=1/10 alpha=9/100-" + number(0, 180) + "/1000" + load);
    case 3:
        return contact_of("tilted-flat-and-rounded t=1/2 alpha=" + number(1, 90) +
                          "/300 R=" + number(2, 9) + load);
    default:
        return contact_of("piecewise knots=-" + number(1, 9) + "/20;0;" + number(1, 9) +
                          "/20 slopes=x/3-1/5;-1/" + number(6, 30) + ";1/" + number(6, 30) +
                          ";1/5+x/9" + load);
    }
}

} // namespace

// The enclosures are compared with closed forms and mpmath in tests/scene/values.txt and
// tests/oracles.
TEST_CASE("contacts of extreme sizes against enclosures") {
    std::vector<Contact> all = symmetric();
    for (const Contact& c : tilted()) {
        all.push_back(c);
    }
    for (const std::string ratio : {"1/5", "1e-12", "999999999/1000000000", "-1/3"}) {
        for (const char* load : {" a=7/5", " P=1/9"}) {
            all.push_back(contact_of("tilted-wedge phi=pi/16 alpha=pi/16*" + ratio + load));
        }
    }
    for (const Contact& c : all) {
        CAPTURE(c.name);
        CHECK(digits_shared(c, 50, Route::singular_integral, {"1e-30", "0.013", "0.3", "0.47"}) >=
              50);
    }
    for (const Contact& c :
         contacts({"power-law m=1 C=1/70 a=1/50", "power-law m=0 C=0.3 a=3/2",
                   "power-law m=2 C=3 a=2", "flat-and-rounded t=2/5 R=3 a=3/2"})) {
        CAPTURE(c.name);
        CHECK(digits_shared(c, 50, Route::barber_mossakovskii, {"1e-30", "0.0005", "0.45"}) >= 50);
    }
}

TEST_CASE("drawn contacts against enclosures") {
    SplitMix64 dice(53);
    for (int k = 0; k < 24; ++k) {
        const Contact c = drawn(dice);
        CAPTURE(k);
        CAPTURE(c.name);
        const bool second = k % 4 == 0;
        CHECK(digits_shared(c, second ? 20 : 40,
                            second ? Route::barber_mossakovskii : Route::singular_integral,
                            {"1e-25", "0.013", "0.471", "0.83"}) >= (second ? 20 : 40));
    }
}

TEST_CASE("200 digits, and 1e-20 from knots") {
    std::vector<Contact> contacts{symmetric()[2], symmetric()[6], tilted()[5], own_symmetric()};
    for (const Contact& c : contacts) {
        CAPTURE(c.name);
        CHECK(digits_shared(c, 200, Route::singular_integral, {"0.3"}) >= 200);
    }
    const Contact flat = symmetric()[6]; // the flat ends at u = 1.1
    const Witness witness = witness_of(flat, 40);
    const BallContact balls(flat.profile, flat.modulus, flat.load, 600);
    const PrecisionScope scope(60);
    for (const char* u : {"1.1", "1.1 + 1e-20", "1.1 - 1e-20", "1.1 + 1e-100"}) {
        CAPTURE(u);
        for (const Route route : both_routes) {
            CHECK(common_digits(witness.pressure(Edge::right, exact(u), route).value,
                                balls.pressure(Edge::right, exact(u)).midpoint()) >= 40);
        }
    }
}

TEST_CASE("an edge just beyond a corner: Barber-Mossakovskii, where P' is nearly infinite") {
    const Contact c =
        contact_of("piecewise symmetric knots=1/4 slopes=x/10;x/10+1/50 a=1/4+1e-20 E=1");
    for (const char* u : {"11e-21", "3e-20", "1/5"}) {
        CAPTURE(u);
        const Witness witness = witness_of(c, 40);
        const BallContact balls(c.profile, c.modulus, c.load, 600);
        const PrecisionScope scope(60);
        CHECK(
            common_digits(witness.pressure(Edge::right, exact(u), Route::barber_mossakovskii).value,
                          balls.pressure(Edge::right, exact(u)).midpoint()) >= 40);
    }
}

TEST_CASE("two precisions and two threads in one process") {
    const Contact c = own_symmetric();
    const auto pressure = [&](unsigned digits) {
        const Witness witness = witness_of(c, digits);
        return witness.pressure(Edge::right, exact("1/9"), Route::singular_integral).value;
    };
    const Real few = pressure(20);
    auto other = std::async(std::launch::async, pressure, 90);
    const Real many = pressure(60);
    const PrecisionScope scope(100);
    CHECK(common_digits(few, many) >= 20);
    CHECK(common_digits(many, other.get()) >= 60);
    CHECK(pressure(20) == few);
}

TEST_CASE("places and loads without a value") {
    const Contact wedge = symmetric()[0]; // a = 3/2
    const Witness witness = witness_of(wedge, 30);
    for (const char* u : {"0", "3", "-1", "3/2"}) { // 3/2: the corner at the apex
        for (const Route route : both_routes) {
            CHECK_THROWS_AS((void)witness.pressure(Edge::right, exact(u), route), DomainError);
        }
    }
    // At 1e-300 from the apex it is large, but finite: (7/10 pi) arcosh(1.5e300).
    const PrecisionScope scope(60);
    const Exact near_apex(exact("3/2").expr() - exact("1e-300").expr());
    CHECK(common_digits(witness.pressure(Edge::right, near_apex, Route::singular_integral).value,
                        Real(7) / 10 / pi<Real>() * log(Real(3) * pow(Real(10), 300))) >= 30);
    for (const char* words :
         {"power-law m=1 C=1 a=0", "power-law m=1 C=1 P=-1", "power-law m=1 C=1 a=1 E=-1"}) {
        CHECK_THROWS_AS((void)witness_of(contact_of(words), 30), InputError);
    }
    // The left side has no slope: no b satisfies the consistency condition.
    CHECK_THROWS_AS((void)witness_of(contact_of("piecewise knots=0 slopes=0;x a=1"), 30),
                    DomainError);
}

TEST_CASE("a curved slope by Barber-Mossakovskii" * doctest::test_suite("slow")) {
    CHECK(digits_shared(own_symmetric(), 20, Route::barber_mossakovskii, {"0.2"}) >= 20);
}
