// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/tilt/tilt_solver.hpp"

#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/contact/enclosure/ball_values.hpp"
#include "edgeproof/precision/error.hpp"
#include "tests/contact/forward.hpp"
#include "tests/contact/scenes.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <utility>

using scenes::agree;
using scenes::exact;

namespace {

Exact exactly(const Real& x) {
    Rational q;
    mpfr_get_q(q.backend().data(), x.backend().data());
    return Exact::of(q);
}

/// The tilt, at bits that suffice for the digits and for those that cancel in the cases below.
EnclosedTilt tilt_to(unsigned digits, const TiltedPunch& punch, const Exact& modulus,
                     const Exact& P, const Exact& M) {
    return enclose_tilt(punch, modulus, P, M, formula::bits_for(2 * digits + 60));
}

/// Checks that the contact under P at the tilt that was found has the force and the moment.
void check_carries(const TiltedPunch& punch, const char* modulus, const Exact& P, const Exact& M,
                   unsigned digits) {
    CAPTURE(P.text());
    CAPTURE(M.text());
    const EnclosedTilt tilt = tilt_to(digits, punch, exact(modulus), P, M);
    // Checked with more digits, so that the agreement is not accidental.
    const Witness contact(tilt.near, exact(modulus), Load::force(P), digits + 30);
    const PrecisionScope scope(digits + 60);
    const int d = static_cast<int>(digits);
    CHECK(agree(contact.force(), P.to<Real>(), d + 20));
    if (M.sign() == 0) {
        CHECK(abs(contact.moment()) < Real("1e-60"));
    } else {
        CHECK(agree(contact.moment(), M.to<Real>(), d));
    }
}

/// Returns the fault of the enclosure of the tilt of a punch under P and M; empty if there is none.
std::string fault_of_enclosure(const TiltedPunch& punch, const char* P, const char* M) {
    const Exact modulus = exact("7/3");
    const EnclosedTilt tilt = enclose_tilt(punch, modulus, exact(P), exact(M), 340);
    if (tilt.alpha.relative_accuracy_bits() < 120) {
        return "too wide";
    }
    // The contact with the ball of tilts, at constant P, has a moment that contains M.
    const BallContact contact(tilt.near, tilt.alpha, modulus, Load::force(exact(P)), 340);
    if (!overlaps(contact.moment(), enclosed_constant(exact(M), 340))) {
        return "another moment";
    }
    return overlaps(contact.mirrored().force(), contact.force()) ? "" : "another force in a mirror";
}

} // namespace

TEST_CASE("the tilt is found again from the force and the moment of a contact") {
    const TiltedPunch wedge = TiltedPunch::wedge(exact("pi/16"));
    const TiltedPunch flat = TiltedPunch::flat_and_rounded(exact("1"), exact("2"));
    const auto check = [](const TiltedPunch& punch, const std::string& alpha,
                          const std::string& words, int digits) {
        CAPTURE(words);
        CAPTURE(alpha);
        const scenes::Contact c = scenes::contact_of(words + " alpha=" + alpha);
        const Witness contact(c.profile, c.modulus, c.load, 70);
        const EnclosedTilt tilt =
            tilt_to(50, punch, c.modulus, exactly(contact.force()), exactly(contact.moment()));
        const PrecisionScope scope(80);
        CHECK(agree(tilt.alpha.midpoint(), exact(alpha).to<Real>(), digits));
        CHECK(tilt.alpha.relative_accuracy_bits() > 150);
    };
    for (const std::string alpha : {"pi/20", "-pi/20", "0.001", "pi/16-1e-6"}) {
        check(wedge, alpha, "tilted-wedge phi=pi/16 a=3/2", 50);
    }
    for (const std::string a : {"0.5", "3"}) { // the paper's punch
        check(flat, "pi/16", "tilted-flat-and-rounded t=1 R=2 E=1 a=" + a, 48);
    }
}

// moore-hills.tex line 303: gamma = b/a is known from alpha, P = E* phi sqrt(gamma) a. The moment
// is the integral of x p over the contact, which shares nothing with the solver.
TEST_CASE("the moment is the integral of x p") {
    const Exact P = exact("2/7");
    const Exact M = exact("-3/11");
    const EnclosedTilt tilt = tilt_to(30, TiltedPunch::wedge(exact("1/5")), exact("3"), P, M);
    const Witness contact(tilt.near, exact("3"), Load::force(P), 30);
    const PrecisionScope scope(60);
    const Extent<Real> e{contact.a(), contact.b()};
    const Real sine = sin(Real(pi<Real>() * tilt.alpha.midpoint() / 2 * 5));
    const Real gamma = (1 - sine) / (1 + sine);
    CHECK(agree(Real(e.b / e.a), gamma, 29));
    CHECK(agree(P.to<Real>(), Real(Real(3) / 5 * sqrt(gamma) * e.a), 29));
    // Split at the apex, where p has a logarithm.
    Real sum = 0;
    for (const bool right : {true, false}) {
        const Real length = right ? e.a : e.b;
        const auto part = integrate_near(
            [&](const Real& from_edge, const Real& from_apex) {
                if (from_apex < length * Real("1e-40")) {
                    return Real(0);
                }
                const Real p = contact
                                   .pressure(right ? Edge::right : Edge::left, exactly(from_edge),
                                             Route::singular_integral)
                                   .value;
                return Real((right ? from_apex : Real(-from_apex)) * p);
            },
            length, Real(0), Real(0), {.target_digits = 25});
        REQUIRE(part.converged);
        sum += part.value;
    }
    CHECK(agree(sum, M.to<Real>(), 24));
}

TEST_CASE("force and moment over extreme ratios: the wedge") {
    const TiltedPunch punch = TiltedPunch::wedge(exact("pi/16"));
    for (const char* M : {"-1e12", "1e-30", "0.7", "0"}) {
        check_carries(punch, "7/3", exact("2"), exact(M), 40);
    }
    check_carries(punch, "2.1e11", exact("1e-12"), exact("1e-20"), 40);
    check_carries(punch, "2.1e11", exact("1e12"), exact("-1e25"), 20);
}

TEST_CASE("force and moment over extreme ratios: the flat-and-rounded punch") {
    const TiltedPunch punch = TiltedPunch::flat_and_rounded(exact("1"), exact("2"));
    // M from -t P (upright) to 0 (the flat lifts off); P from a tiny contact beyond the flat to one
    // much larger than the flat.
    for (const char* P : {"1e-9", "0.3", "1e4"}) {
        for (const char* part : {"-1 + 1e-25", "-0.999", "-1/2", "-1e-3", "-1e-25"}) {
            const Exact M(exact(P).expr() * exact(part).expr());
            check_carries(punch, "7/3", exact(P), M, 40);
        }
    }
    // The upright punch itself.
    const EnclosedTilt upright = tilt_to(30, punch, exact("7/3"), exact("0.3"), exact("-0.3"));
    CHECK(upright.exactly_zero);
    CHECK(upright.near.kind() == Profile::Kind::tilted_flat_and_rounded);
}

// For R = 0 the moment about the middle of the flat is pi E* alpha t^2/4 (docs/mechanics.md,
// "Profiles"). The contact of a sharp corner differs by about R^(2/3).
TEST_CASE("a nearly sharp corner has nearly the tilt of a sharp one") {
    for (const auto& [R, near] : {std::pair("1e-60", "1e-38"), std::pair("1e-100", "1e-64")}) {
        const EnclosedTilt tilt = enclose_tilt(TiltedPunch::flat_and_rounded(exact("1"), exact(R)),
                                               exact("1"), exact("1"), exact("-1/2"), 2048);
        const Ball off = tilt.alpha - 2 / Ball::pi(2048);
        CHECK(certainly_less(abs(off), enclosed_constant(exact(near), 64)));
        CHECK(tilt.alpha.relative_accuracy_bits() > 256);
    }
}

TEST_CASE("where no tilt exists, the error gives the reason") {
    const auto fails = [](const TiltedPunch& punch, const char* P, const char* M,
                          const char* words) {
        try {
            (void)tilt_to(20, punch, exact("1"), exact(P), exact(M));
            FAIL("no error");
        } catch (const InputError& error) {
            CHECK(std::string(error.what()).find(words) != std::string::npos);
        }
    };
    const TiltedPunch punch = TiltedPunch::flat_and_rounded(exact("1"), exact("2"));
    fails(punch, "1", "-1.5", "mirror the scene");
    fails(punch, "1", "0", "between -t P and 0");
    fails(punch, "1", "1/2", "between -t P and 0");
    fails(punch, "0", "-1/2", "the normal force P = 0 is not positive");
    fails(punch, "-1", "-1/2", "the normal force P = -1 is not positive");
    fails(TiltedPunch::flat_and_rounded(exact("0"), exact("2")), "1", "0", "t = 0");
    fails(TiltedPunch::flat_and_rounded(exact("1"), exact("-2")), "1", "0",
          "the radius R = -2 is not positive");
    fails(TiltedPunch::wedge(exact("0")), "1", "0", "phi = 0 is not");
}

TEST_CASE("the tilt is enclosed, narrowly, and so are the moment and the force with it") {
    const TiltedPunch flat = TiltedPunch::flat_and_rounded(exact("1"), exact("2"));
    CHECK(fault_of_enclosure(TiltedPunch::wedge(exact("pi/16")), "2", "-0.7") == "");
    CHECK(fault_of_enclosure(flat, "0.3", "-0.2") == "");
    const EnclosedTilt upright = enclose_tilt(flat, exact("7/3"), exact("0.3"), exact("-0.3"), 300);
    CHECK(upright.exactly_zero);
}

TEST_CASE("the tilt is enclosed over extreme ratios" * doctest::test_suite("slow")) {
    const TiltedPunch wedge = TiltedPunch::wedge(exact("pi/16"));
    const TiltedPunch flat = TiltedPunch::flat_and_rounded(exact("1"), exact("2"));
    CHECK(fault_of_enclosure(wedge, "2", "1e-30") == "");
    CHECK(fault_of_enclosure(wedge, "1e-12", "1e-3") == "");
    CHECK(fault_of_enclosure(flat, "0.3", "-0.3 + 1e-25") == "");
    CHECK(fault_of_enclosure(flat, "1e4", "-1e-21") == "");
}

TEST_CASE("the enclosure of a tilt ends at every precision that is too low for the moment") {
    for (const long bits : {180, 260}) {
        CAPTURE(bits);
        CHECK_THROWS_AS((void)enclose_tilt(TiltedPunch::flat_and_rounded(exact("1"), exact("2")),
                                           exact("1"), exact("1"), exact("-1 + 1e-90"), bits),
                        BudgetError);
    }
    // d(M)/d(alpha) = pi E* c^2/4 - P R at alpha = 0, with the half-width c of the upright punch
    const EnclosedTilt enough = enclose_tilt(TiltedPunch::flat_and_rounded(exact("1"), exact("2")),
                                             exact("1"), exact("1"), exact("-1 + 1e-90"), 900);
    const BallContact upright(Profile::flat_and_rounded(exact("1"), exact("2")), exact("1"),
                              Load::force(exact("1")), 900);
    const Ball rate = Ball::pi(900) * upright.a() * upright.a() / 4 - 2;
    const Ball near = Ball(Rational(1, pow(Integer(10), 90)), 900) / rate;
    CHECK(certainly_less(abs(enough.alpha - near), near * power_of_two(-250, 900)));
}
