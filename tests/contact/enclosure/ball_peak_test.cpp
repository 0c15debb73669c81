// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/enclosure/ball_relative_error.hpp"

#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "tests/contact/scenes.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace edgeproof::scenes;

namespace {

/// Checks that both ends are within a relative 10^-`digits` of the value, on their own sides of it:
/// an enclosure that is no wider than necessary. The value is right to 50 digits.
void check_both_ends(const Ball& peak, const Real& value, int digits) {
    const Real slack = abs(value) * Real("1e-50");
    const Real width = abs(value) * pow(Real(10), -digits);
    CHECK(peak.lower() <= value + slack);
    CHECK(peak.upper() >= value - slack);
    CHECK(value - peak.lower() <= width);
    CHECK(peak.upper() - value <= width);
}

/// Peaks of flat-and-rounded punches by mpmath at 70 digits, not by the closed form: with
/// w = sqrt((a - x)(b + x)) and t = (a - b)/2 + (a + b)/2 cos(h),
///     p(x) = E*/(2 pi) w(x) int_0^pi (g'(t(h)) - g'(x))/(t(h) - x) dh
/// by tanh-sinh between the knots, b from int_0^pi g'(t(h)) dh = 0, and the root of p' by findroot.
struct PeakByQuadrature {
    Contact contact;
    const char* peak;
};

std::vector<PeakByQuadrature> peaks_by_quadrature() {
    const Profile tilted = Profile::tilted_flat_and_rounded(exact("pi/16"), exact("1"), exact("2"));
    return {
        {{"flat and rounded", Profile::flat_and_rounded(exact("0.4"), exact("3")), exact("2.1e11"),
          Load::right_edge(exact("1.5"))},
         "33553871781.41589042376722405526213394218897024387078045"},
        {{"tilted, left edge on the flat", tilted, exact("7/3"), Load::right_edge(exact("0.5"))},
         "0.2910231600389889484327187880464812094822972699267685037"},
        {{"tilted, left edge on the far arc", tilted, exact("7/3"), Load::right_edge(exact("3"))},
         "1.593359949476460898872779967765398925488274220138494088"}};
}

} // namespace

TEST_CASE("the greatest pressure of Hertz: E* a/(2R) = 2P/(pi a)") {
    const PrecisionScope scope(70);
    // C = 1/R = 1/70, a = 1/50, E* = 7/3: E* a C/2 = 1/3000.
    const BallContact contact(Profile::power_law(exact("1/70"), exact("1")), exact("7/3"),
                              Load::right_edge(exact("1/50")), 256);
    const Real by_hand = Real(1) / 3000;
    const Ball pi_a = Ball::pi(256) * contact.a();
    for (const bool symmetric : {true, false}) {
        CAPTURE(symmetric);
        const Ball peak = enclosed_peak(contact, symmetric);
        check_both_ends(peak, by_hand, 50);
        CHECK(overlaps(peak, 2 * contact.force() / pi_a));
    }
}

TEST_CASE("the greatest pressure of flat-and-rounded punches, upright and tilted") {
    const PrecisionScope scope(70);
    for (const PeakByQuadrature& each : peaks_by_quadrature()) {
        const Contact& c = each.contact;
        const char* const value = each.peak;
        CAPTURE(c.name);
        const bool symmetric = c.profile.symmetric();
        Real last = 1;
        for (const long bits : {128L, 256L, 512L}) {
            CAPTURE(bits);
            const BallContact contact(c.profile, c.modulus, c.load, bits);
            const Ball peak = enclosed_peak(contact, symmetric);
            // The digits of the bits minus ten, but no more than the value has.
            check_both_ends(peak, Real(value), std::min(50, static_cast<int>(bits * 3 / 10) - 10));
            // More bits give a narrower enclosure.
            const Real relative = peak.radius() / peak.midpoint();
            CHECK(relative < last * Real("1e-25"));
            last = relative;
        }
    }
}

TEST_CASE("two equal maxima: the peak is still enclosed") {
    const PrecisionScope scope(70);
    const auto [c, value] = peaks_by_quadrature()[0];
    const BallContact contact(c.profile, c.modulus, c.load, 256);
    check_both_ends(enclosed_peak(contact, false), Real(value), 15);
}
