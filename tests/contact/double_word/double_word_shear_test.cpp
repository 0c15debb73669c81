// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/double_word/double_word_shear.hpp"
#include "edgeproof/contact/slip/ball_slip.hpp"
#include "edgeproof/precision/rounding/text.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <memory>

using namespace edgeproof;

namespace {

constexpr long word_bits = DoubleWordPressure::contact_bits;

Exact traction_number(const char* text) { return Exact::parse(text); }

/// The traction q of a contact with a = 1 and E* = 1 under a shear force with f = 1/2, in double
/// words and in balls of many bits.
struct SlippingTwice {
    BallContact contact;
    std::unique_ptr<ZoneSolver> zones;
    BallSlip slip; ///< refers to both
    DoubleWordShear words;

    SlippingTwice(const Profile& profile, const Rational& Q)
        : contact(profile, traction_number("1"), load(), ball_bits),
          zones(closed_form_zones(contact)), slip(slip_of(contact, *zones, Q)),
          words(in_words(profile, Q)) {}
    [[nodiscard]] double at(Edge edge, double u) const {
        const Ball from(Rational(u), ball_bits);
        return slip.traction(edge, from, contact.pressure(edge, from))
            .midpoint()
            .convert_to<double>();
    }

private:
    static constexpr long ball_bits = 400;
    static Load load() { return Load::right_edge(traction_number("1")); }
    static BallSlip slip_of(const BallContact& contact, const ZoneSolver& zones,
                            const Rational& Q) {
        const long bits = contact.bits();
        return {contact, zones, contact.force(), ShearLoad<Ball>{Ball(Q, bits), Ball(0, bits)},
                Ball(Rational(1, 2), bits)};
    }
    static DoubleWordShear in_words(const Profile& profile, const Rational& Q) {
        const BallContact contact(profile, traction_number("1"), load(), word_bits);
        const auto zones = closed_form_zones(contact);
        return DoubleWordShear::partial_slip(profile, contact, slip_of(contact, *zones, Q).stick(),
                                             Ball(Rational(1, 2), word_bits));
    }
};

} // namespace

TEST_CASE("q under full stick in double words: by the formula in Real, Q and sigma_0 against each "
          "other") {
    const BallContact contact(
        Profile::flat_and_rounded(traction_number("1/2"), traction_number("3")),
        traction_number("1"), Load::right_edge(traction_number("1")), word_bits);
    const ShearLoad<Ball> load{Ball(Rational(3, 10), word_bits), Ball(Rational(-7, 9), word_bits)};
    const DoubleWordShear words = DoubleWordShear::full_stick(contact, load);
    for (const double u : {1e-60, 1e-17, 0.001, 0.3, 1.0, 1.25, 1.999}) {
        CAPTURE(u);
        const PrecisionScope scope(60);
        const Real right(u);
        const Real left = 2 - right;
        const Real q = (Real(3) / 10 / pi<Real>() + Real(-7) / 9 * (left - right) / 8) /
                       sqrt(Real(right * left));
        CHECK(words.nearest(Edge::right, u) == q.convert_to<double>());
    }
    CHECK_FALSE(words.nearest(Edge::right, 2.5));
}

TEST_CASE("q in partial slip in double words: that of balls, stuck and slipping") {
    for (const char* m : {"1", "1/2", "2"}) {
        CAPTURE(m);
        const Profile profile = Profile::power_law(traction_number("1"), traction_number(m));
        const SlippingTwice q_of(profile, Rational(1, 10));
        for (const double u : {1e-20, 0.01, 0.05, 0.3, 0.77, 1.3, 1.98}) {
            CAPTURE(u);
            const auto q = q_of.words.nearest(Edge::left, u);
            REQUIRE(q);
            const double second = q_of.at(Edge::left, u);
            CHECK(std::abs(*q - second) <= 2e-16 * std::abs(second));
        }
    }
}

TEST_CASE("q of a wedge in partial slip in double words: at its apex and at the stick zone's edge, "
          "by hand") {
    // p = (1/pi) arcosh(1/|x|), P = 1. For Q = f P/2 the stick zone ends at 1/2, p* is the pressure
    // at x/(1/2), and p - p* at the apex is (ln 2)/pi.
    const Profile wedge = Profile::power_law(traction_number("1"), traction_number("0"));
    const BallContact contact(wedge, traction_number("1"), Load::right_edge(traction_number("1")),
                              word_bits);
    const auto zones = closed_form_zones(contact);
    const Ball friction(Rational(1, 3), word_bits);
    const BallSlip balls(contact, *zones, contact.force(),
                         {Ball(Rational(1, 6), word_bits), Ball(0, word_bits)}, friction);
    const DoubleWordShear words =
        DoubleWordShear::partial_slip(wedge, contact, balls.stick(), friction);
    const PrecisionScope scope(160);
    const auto by_hand = [](double u) {
        const Real x = abs(Real(1 - Real(u)));
        const auto arcosh = [](const Real& y) {
            return y > 1 ? Real(log(Real(y + sqrt(Real(y * y - 1))))) : Real(0);
        };
        const Real q = x == 0 ? log(Real(2)) : Real(arcosh(1 / x) - arcosh(1 / (2 * x)));
        return Real(q / (3 * pi<Real>())).convert_to<double>();
    };
    for (const Edge edge : {Edge::right, Edge::left}) {
        for (const double u :
             {1e-50, 0.2, std::nextafter(0.5, 0.0), 0.5, std::nextafter(0.5, 1.0), 0.500001, 0.7,
              std::nextafter(1.0, 0.0), 1.0, std::nextafter(1.0, 2.0), 1.5, 1.75}) {
            CAPTURE(u);
            CHECK(words.nearest(edge, u) == by_hand(u));
        }
    }
}

TEST_CASE("q in partial slip in double words keeps its digits where the stick zone is all but the "
          "contact") {
    struct Case {
        const char* name;
        Profile profile;
    };
    for (const Case& drawn :
         {Case{"Hertz", Profile::power_law(traction_number("1"), traction_number("1"))},
          Case{"flat and rounded",
               Profile::flat_and_rounded(traction_number("1/2"), traction_number("3"))},
          Case{"tilted wedge",
               Profile::tilted_wedge(traction_number("1/5"), traction_number("1/20"))}}) {
        CAPTURE(drawn.name);
        const Profile& profile = drawn.profile;
        const SlippingTwice q_of(profile, parse_decimal("1e-13"));
        for (const double u : {1e-20, 1e-13, 1e-12, 1e-9, 0.01, 0.3, 0.5, 0.50001, 0.9, 0.999}) {
            CAPTURE(u);
            CHECK(q_of.words.nearest(Edge::right, u) == q_of.at(Edge::right, u));
        }
    }
}

TEST_CASE("q similar to p in double words is Q/P times p") {
    const Profile profile = Profile::power_law(traction_number("2"), traction_number("1"));
    const BallContact contact(profile, traction_number("1"), Load::right_edge(traction_number("1")),
                              word_bits);
    // P = pi E* C a^2/4 = pi/2 and p = C sqrt(1 - x^2)/2.
    const DoubleWordShear words = DoubleWordShear::similar(
        {profile, contact}, Ball(Rational(1, 3), word_bits) / contact.force());
    CHECK(words.nearest(Edge::right, 1.0) == 2 / (3 * std::acos(-1.0)));
    CHECK(std::abs(*words.nearest(Edge::right, 0.4) - 0.8 * 2 / (3 * std::acos(-1.0))) < 1e-16);
}
