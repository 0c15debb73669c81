// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/curved/integrated_contact.hpp"
#include "edgeproof/precision/error.hpp"
#include "tests/contact/scenes.hpp"

#include <doctest/doctest.h>

#include <string>

using namespace edgeproof::scenes;

TEST_CASE("a slope that falls beyond the contact: a load that reaches there is refused") {
    const auto refuse = [](const char* slope, const Load& load) {
        const Profile profile = curve("", slope);
        try {
            (void)IntegratedContact(profile, exact("1"), load, 96);
            FAIL("accepted: ", slope);
        } catch (const InputError& e) {
            CHECK_MESSAGE(std::string(e.what()).find("could not be shown to rise beyond x = ") !=
                              std::string::npos,
                          e.what());
        }
    };
    // The end of the increase by hand: pi/2, pi/2 (a pole), sqrt(10/3), 1 (the end of the domain).
    struct Fall {
        const char* slope;
        const char* inside;
        const char* outside;
    };
    for (const Fall& f : {Fall{"sin(x)", "1.5707", "1.5709"}, Fall{"tan(x)", "1.56", "1.5709"},
                          Fall{"x*(1 - x^2/10)", "1.8257", "1.8258"},
                          Fall{"asin(x)", "0.99", "1.0001"}, Fall{"atanh(x)", "0.99", "2"}}) {
        CAPTURE(f.slope);
        const Profile profile = curve("", f.slope);
        CHECK_NOTHROW(
            (void)IntegratedContact(profile, exact("1"), Load::right_edge(exact("1/2")), 96));
        CHECK_NOTHROW(
            (void)IntegratedContact(profile, exact("1"), Load::right_edge(exact(f.inside)), 96));
        refuse(f.slope, Load::right_edge(exact(f.outside)));
    }
    refuse("sin(x)", Load::force(exact("10"))); // the force at pi/2 is smaller
}

TEST_CASE("profiles that are refused") {
    CHECK_THROWS_AS((void)Profile::power_law(exact("1"), exact("-1/2")), InputError);
    CHECK_THROWS_AS((void)Profile::power_law(exact("0"), exact("1")), InputError);
    CHECK_THROWS_AS((void)Profile::flat_and_rounded(exact("-1"), exact("1")), InputError);
    CHECK_THROWS_AS((void)Profile::flat_and_rounded(exact("1"), exact("0")), InputError);
    CHECK_THROWS_AS((void)Profile::tilted_wedge(exact("pi/16"), exact("pi/16")), InputError);
    CHECK_THROWS_AS((void)Profile::tilted_wedge(exact("pi/16"), exact("-1")), InputError);
    struct Refused {
        const char* part; ///< of the message
        const char* knots;
        const char* slopes;
    };
    for (const Refused& r : {Refused{"decreases", "", "-x"},
                             {"decreases", "1", "x; x - 1/2"},
                             {"decreases", "", "-sin(3*x)"},
                             {"decreases", "3/2", "sin(3*x); x"},
                             {"origin", "", "x - 1"},
                             {"ascend", "2; 1", "x; x; x"},
                             {"one piece more", "2", "x"}}) {
        try {
            (void)curve(r.knots, r.slopes);
            FAIL("accepted: ", r.part);
        } catch (const InputError& e) {
            CHECK_MESSAGE(std::string(e.what()).find(r.part) != std::string::npos, e.what());
        }
    }
}
