// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/curved/integrated_contact.hpp"
#include "edgeproof/precision/error.hpp"
#include "tests/contact/scenes.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

using namespace edgeproof::scenes;

namespace {

struct Case {
    std::string name;
    std::vector<const char*> knots;
    std::vector<const char*> slopes;
    bool symmetric; ///< the slopes are given only for x > 0
    const char* a;
    const char* b;
    const char* P;
    const char* p; ///< at u = 1/10 from the right edge
};

/// E* = 1. b, P and p by mpmath 1.2 at 40 digits, with theta from s = c + d cos theta: the integral
/// of g'(s) is 0; P is (d/2) times the integral of g'(s) cos theta; p is sqrt(u (2 d - u))/(2 pi)
/// times the integral of (g'(s) - g'(x))/(s - x); theta is split at the knots.
const std::vector<Case>& family() {
    static const std::vector<Case> cases{
        {"sin",
         {},
         {"sin(x)"},
         true,
         "0.8",
         "0.8",
         "0.463500584937788937910136938115",
         "0.168381499238527977658019470019"},
        {"tan",
         {},
         {"tan(x)"},
         true,
         "0.8",
         "0.8",
         "0.605318161133051463946148099745",
         "0.265050857062387673180266114242"},
        {"cubic, falls at 1.83",
         {"0"},
         {"x*(1 - x^2/10)", "x*(1 - x^2/10)"},
         false,
         "0.8",
         "0.8",
         "0.478527392994797306082629840141",
         "0.17796358475823080587398724512"},
        {"atan | 2 x",
         {"0"},
         {"atan(x)", "2*x"},
         false,
         "0.8",
         "1.50721940711382652650634451631",
         "1.1514812842869242542880617778",
         "0.378627275087569748131914154807"},
        {"x | 0 | root of 3/2",
         {"0", "1/5"},
         {"x", "0", "(x - 1/5)^(3/2)"},
         false,
         "0.8",
         "0.467143418806692937884987301347",
         "0.209479124152003517707768682653",
         "0.137546423494109221130210463417"},
        {"root of 3/2 | 0 | x",
         {"-1/5", "0"},
         {"-(-x - 1/5)^(3/2)", "0", "x"},
         false,
         "0.8",
         "1.10122526462537655066289482965",
         "0.570812836977507609597501778558",
         "0.188873296230699546447778994811"},
        {"x | 0 | root",
         {"0", "1/5"},
         {"x", "0", "sqrt(x - 1/5)"},
         false,
         "0.8",
         "0.791155397676424926533139028586",
         "0.49798214032331197733576094253",
         "0.179167628866199084678583102335"},
        {"sinh | 0 | cubic",
         {"0", "1"},
         {"sinh(x)", "0", "(x-1)^3"},
         false,
         "2",
         "0.742537234147455065429500273815",
         "0.699129906554225829875952995202",
         "0.281447116111705367127963407457"},
        {"x |x|",
         {},
         {"x^2"},
         true,
         "0.8",
         "0.8",
         "0.341333333333333333333333333333",
         "0.181033271420563545213416934412"},
        {"x | gamma",
         {"0"},
         {"x", "x*gamma(x + 2)"},
         false,
         "0.8",
         "1.02909291815032368358960322931",
         "0.80245447948270287606080380348",
         "0.352075890558745955053032688711"},
        {"x | log",
         {"0"},
         {"x", "log(1 + 3*x)"},
         false,
         "0.8",
         "1.12798823032900846976465023222",
         "0.919933931988925718603991549272",
         "0.26266888965030745868139799679"},
        {"exp",
         {"0"},
         {"1 - exp(-x)", "exp(x) - 1"},
         false,
         "0.8",
         "0.8",
         "0.722036911960754339562582947243",
         "0.316780132892867571774953939604"},
    };
    return cases;
}

Profile profile_of(const Case& c) {
    std::vector<Exact> knots;
    std::vector<Expr> slopes;
    for (const char* knot : c.knots) {
        knots.push_back(exact(knot));
    }
    for (const char* slope : c.slopes) {
        slopes.push_back(parse(slope, Symbols{"x"}));
    }
    return c.symmetric ? Profile::piecewise_symmetric(knots, slopes)
                       : Profile::piecewise(knots, slopes);
}

bool agrees(const Real& x, const char* expected, int digits) {
    const PrecisionScope scope(60);
    return agree(x, exact(expected).to<Real>(), digits);
}

constexpr int mpmath_digits = 26;

} // namespace

TEST_CASE("slopes of every kind: b, P and p agree with mpmath, with a or P given, and mirrored") {
    const Exact u = exact("1/10");
    for (const Case& c : family()) {
        CAPTURE(c.name);
        const Profile profile = profile_of(c);
        const Exact one = exact("1");
        const Witness by_a(profile, one, Load::right_edge(exact(c.a)), 30);
        CHECK(agrees(by_a.b(), c.b, mpmath_digits));
        CHECK(agrees(by_a.force(), c.P, mpmath_digits));
        CHECK(agrees(by_a.pressure(Edge::right, u, Route::singular_integral).value, c.p,
                     mpmath_digits));
        const Witness by_P(profile, one, Load::force(exact(c.P)), 30);
        CHECK(agrees(by_P.a(), c.a, mpmath_digits));
        CHECK(agrees(by_P.b(), c.b, mpmath_digits));
        const Witness mirrored(profile.reflected(), one, Load::force(exact(c.P)), 30);
        CHECK(agrees(mirrored.a(), c.b, mpmath_digits));
        CHECK(agrees(mirrored.pressure(Edge::left, u, Route::singular_integral).value, c.p,
                     mpmath_digits));
    }
}

TEST_CASE("slopes of every kind: the second route, flat punches laid over each other" *
          doctest::test_suite("slow")) {
    const Exact u = exact("1/10");
    for (const Case& c : family()) {
        CAPTURE(c.name);
        const Witness contact(profile_of(c), exact("1"), Load::right_edge(exact(c.a)), 12);
        CHECK(agrees(contact.pressure(Edge::right, u, Route::barber_mossakovskii).value, c.p, 12));
    }
}

TEST_CASE("slopes of every kind: enclosures hold the values of mpmath, and are narrow") {
    const Exact u = exact("1/10");
    for (const Case& c : family()) {
        CAPTURE(c.name);
        const Profile profile = profile_of(c);
        for (const bool by_force : {false, true}) {
            CAPTURE(by_force);
            const Load load = by_force ? Load::force(exact(c.P)) : Load::right_edge(exact(c.a));
            const IntegratedContact contact(profile, exact("1"), load, 160);
            CHECK(agrees(contact.b().midpoint(), c.b, mpmath_digits));
            const Ball p = contact.pressure(Edge::right, u);
            CHECK(agrees(p.midpoint(), c.p, mpmath_digits));
            CHECK(p.radius() < pow(Real(10), -mpmath_digits));
        }
    }
}

TEST_CASE("a slope that falls beyond the contact: a load that reaches there is refused") {
    const auto refuse = [](const char* slope, const Load& load) {
        const Profile profile = Profile::piecewise({}, {parse(slope, Symbols{"x"})});
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
        const Profile profile = Profile::piecewise({}, {parse(f.slope, Symbols{"x"})});
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
        std::vector<const char*> knots;
        std::vector<const char*> slopes;
    };
    for (const Refused& r : {Refused{"decreases", {}, {"-x"}},
                             {"decreases", {"1"}, {"x", "x - 1/2"}},
                             {"decreases", {}, {"-sin(3*x)"}},
                             {"decreases", {"3/2"}, {"sin(3*x)", "x"}},
                             {"origin", {}, {"x - 1"}},
                             {"ascend", {"2", "1"}, {"x", "x", "x"}},
                             {"one piece more", {"2"}, {"x"}}}) {
        std::vector<Exact> knots;
        std::vector<Expr> slopes;
        for (const char* knot : r.knots) {
            knots.push_back(exact(knot));
        }
        for (const char* slope : r.slopes) {
            slopes.push_back(parse(slope, Symbols{"x"}));
        }
        try {
            (void)Profile::piecewise(knots, slopes);
            FAIL("accepted: ", r.part);
        } catch (const InputError& e) {
            CHECK_MESSAGE(std::string(e.what()).find(r.part) != std::string::npos, e.what());
        }
    }
}
