// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/contact/tilt/tilt_solver.hpp"

#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/contact/enclosure/ball_values.hpp"
#include "edgeproof/precision/error.hpp"
#include "tests/contact/scenes.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <utility>

using scenes::agree;
using scenes::exact;

namespace {

Exact exactly(const Real& x) { return Exact::of(Rational(x)); }

/// The tilt, at bits that suffice for the digits and for those that cancel in the cases below.
EnclosedTilt tilt_to(unsigned digits, const TiltedPunch& punch, const Exact& modulus,
                     const Exact& P, const Exact& M) {
    return enclose_tilt(punch, modulus, P, M, formula::bits_for(2 * digits + 60));
}

/// Checks that the tilt is enclosed narrowly, and that the contact under P at the tilt that was
/// found has the force and the moment: by the witness, and by balls with the ball of tilts, in a
/// mirror too.
void check_carries(const TiltedPunch& punch, const char* modulus, const Exact& P, const Exact& M,
                   unsigned digits) {
    CAPTURE(P.text());
    CAPTURE(M.text());
    const EnclosedTilt tilt = tilt_to(digits, punch, exact(modulus), P, M);
    CHECK(tilt.alpha.relative_accuracy_bits() > 3 * static_cast<long>(digits));
    const long bits = tilt.alpha.bits();
    const BallContact balls(tilt.near, tilt.alpha, exact(modulus), Load::force(P), bits);
    CHECK(overlaps(balls.moment(), enclosed_constant(M, bits)));
    CHECK(overlaps(balls.mirrored().force(), balls.force()));
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

TEST_CASE("force and moment over extreme ratios: the wedge") {
    const TiltedPunch punch = TiltedPunch::wedge(exact("pi/16"));
    for (const char* M : {"-1e12", "1e-30", "0.7", "0"}) {
        check_carries(punch, "7/3", exact("2"), exact(M), 40);
    }
    check_carries(punch, "2.1e11", exact("1e-12"), exact("1e-20"), 40);
    check_carries(punch, "2.1e11", exact("1e12"), exact("-1e25"), 20);
    check_carries(punch, "7/3", exact("1e-12"), exact("1e-3"), 40);
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
