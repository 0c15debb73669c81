// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/enclosure/ball_extent.hpp"
#include "edgeproof/contact/enclosure/ball_relative_error.hpp"

#include "edgeproof/contact/enclosure/ball_contact.hpp"

#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/rounding/text.hpp"
#include "tests/contact/scenes.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>

using namespace edgeproof::scenes;

namespace {

/// The contacts of one scene at each number of bits.
class Contacts {
public:
    Contacts(Profile profile, Load load) : profile_(std::move(profile)), load_(std::move(load)) {}
    const BallContact& operator()(long bits) {
        auto& slot = made_[bits];
        if (!slot) {
            slot = std::make_unique<BallContact>(profile_, exact("1"), load_, bits);
        }
        return *slot;
    }
    [[nodiscard]] Witness witness(unsigned digits) const {
        return {profile_, exact("1"), load_, digits};
    }

private:
    Profile profile_;
    Load load_;
    std::map<long, std::unique_ptr<BallContact>> made_;
};

EnclosedExtents enclosed(Contacts& contacts, Edge edge, std::size_t n, const char* tolerance,
                         const ExtentRange& range = {}, long bits = 400) {
    BallExtentSearch search([&](long b) -> const BallContact& { return contacts(b); }, edge, n,
                            exact(tolerance), range);
    return search.at(bits);
}

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

// p = C sqrt(u (2a - u)): with s = u/(2a), the ratio of one term to p is 1/sqrt(1-s), of two terms
// (1 - s/2)/sqrt(1-s).
TEST_CASE("Hertz: the enclosed exits hold the roots of a linear and a quadratic") {
    Contacts hertz(Profile::power_law(exact("1"), exact("1")), Load::right_edge(exact("3/2")));
    for (const char* tol : {"1/100", "1/20", "1e-12", "1e-30", "3"}) {
        CAPTURE(std::string(tol));
        const EnclosedExtents one = enclosed(hertz, Edge::right, 1, tol);
        const EnclosedExtents two = enclosed(hertz, Edge::left, 2, tol);
        const Ball k = 1 + Ball(exact(tol).rational(), 600);
        const Ball excess = k * k - 1;
        const Ball s1 = excess / (k * k);
        const Ball s2 = (sqrt(excess * excess + excess) - excess) * 2;
        CHECK(overlaps(one.first_exit, s1 * 3));
        CHECK(overlaps(one.measure, s1 * 3));
        CHECK(overlaps(two.first_exit, s2 * 3));
        CHECK(one.first_exit.relative_accuracy_bits() > 180);
        CHECK(two.first_exit.relative_accuracy_bits() > 180);
        CHECK(one.crossings.size() == 1);
        CHECK(two.crossings.size() == 1);
        CHECK(one.leaves);
    }
    const EnclosedExtents inner =
        enclosed(hertz, Edge::right, 1, "1/100", {exact("1/1000"), exact("1/500")});
    CHECK_FALSE(inner.leaves);
    CHECK(contains(inner.measure, Rational(3, 1000)));
    CHECK(inner.measure.relative_accuracy_bits() > 180);
}

TEST_CASE("by pressures of the witness, the error is the tolerance at crossings and less before "
          "the exit") {
    struct Asked {
        Profile profile;
        Load load;
        std::size_t n;
        const char* tolerance;
    };
    const auto unit = Load::right_edge(exact("1"));
    const std::vector<Asked> all = {
        {Profile::flat_and_rounded(exact("2/5"), exact("1")), unit, 1, "1/100"},
        {Profile::flat_and_rounded(exact("4/5"), exact("1")), unit, 3, "1/100"},
        {Profile::flat_and_rounded(exact("1"), exact("1")), Load::right_edge(exact("1 + 1e-20")), 1,
         "1/100"},
        {Profile::power_law(exact("1"), exact("0")), unit, 2, "1/10"},
        {Profile::power_law(exact("1"), exact("5/8")), unit, 2, "1/100"},
        {Profile::power_law(exact("1"), exact("10")), unit, 3, "1/50"},
        {Profile::tilted_wedge(exact("pi/16"), exact("pi/20")), unit, 2, "1/100"},
        {Profile::tilted_flat_and_rounded(exact("pi/16"), exact("1"), exact("2")),
         Load::right_edge(exact("3")), 2, "1/20"},
        {Profile::tilted_wedge(exact("pi/16"), exact("pi/20")), Load::force(exact("1/10")), 1,
         "1e-9"}};
    for (const Asked& asked : all) {
        Contacts contacts(asked.profile, asked.load);
        const Witness witness = contacts.witness(25);
        for (const Edge edge : {Edge::right, Edge::left}) {
            CAPTURE(asked.profile.kind_name());
            CAPTURE(std::string(asked.tolerance));
            const EnclosedExtents balls = enclosed(contacts, edge, asked.n, asked.tolerance);
            const PrecisionScope scope(50);
            const std::vector<Real> c = witness.coefficients(edge, asked.n);
            const auto error = [&](const Real& u) { // in units of the tolerance
                Real sum = c.back();
                for (std::size_t k = c.size() - 1; k-- > 0;) {
                    sum = sum * u + c[k];
                }
                const Real p =
                    witness.pressure(edge, Exact::parse(u.str(45)), Route::singular_integral).value;
                return Real(abs(Real(sum * sqrt(u) / p - 1)) / exact(asked.tolerance).to<Real>());
            };
            const Real first = balls.first_exit.midpoint();
            for (int k = 1; k < 12; ++k) {
                CHECK(error(Real(first * k / 12)) < 1);
            }
            CHECK(balls.leaves == !balls.crossings.empty());
            CHECK(balls.first_exit.relative_accuracy_bits() > 166);
            CHECK(balls.measure.relative_accuracy_bits() > 166);
            for (const Ball& crossing : balls.crossings) {
                CHECK(abs(Real(error(crossing.midpoint()) - 1)) < Real("1e-9"));
            }
        }
    }
}

TEST_CASE("a corner too faint to see is a crossing at its place; a touch is left undecided") {
    // The logarithm matters only within e^(-10^6) of the corner.
    Contacts faint(Profile::piecewise({exact("0")}, {parse("x - 1e-9", Symbols{"x"}),
                                                     parse("x + 1e-9", Symbols{"x"})}),
                   Load::right_edge(exact("1")));
    const EnclosedExtents e = enclosed(faint, Edge::right, 40, "1/100", {exact("0"), exact("3/4")});
    CHECK(e.measure.lower() > 1);
    REQUIRE(e.crossings.size() >= 2);
    const auto is_one = [](const Ball& x) {
        return contains(x, Rational(1)) && x.relative_accuracy_bits() > 166;
    };
    CHECK(is_one(e.crossings[0]));
    CHECK(is_one(e.crossings[1]));
    // One term is above the tolerance on both sides of the corner; its error goes to -1 and back,
    // four times.
    const EnclosedExtents above =
        enclosed(faint, Edge::right, 1, "1/100", {exact("0"), exact("3/4")});
    REQUIRE(above.crossings.size() == 5);
    CHECK(certainly_less(above.crossings[0], Ball(1, 400) / 20));
    CHECK(is_one(above.crossings[1]));
    CHECK(is_one(above.crossings[4]));
    CHECK(overlaps(above.measure, above.first_exit));
    // Hertz, one term, with the tolerance that its error reaches at 3/4 of the contact, the end of
    // the range.
    Contacts hertz(Profile::power_law(exact("1"), exact("1")), Load::right_edge(exact("1")));
    CHECK_THROWS_AS((void)enclosed(hertz, Edge::right, 1, "1", {exact("0"), exact("3/4")}),
                    BudgetError);
    const Ball exit = enclosed(hertz, Edge::right, 1, "1").first_exit;
    CHECK(contains(exit, Rational(3, 2)));
    CHECK(exit.relative_accuracy_bits() > 166);
}

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
