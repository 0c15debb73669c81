// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/slip/ball_slip.hpp"

#include "edgeproof/contact/slip/slip_reach.hpp"
#include "tests/contact/slip_scenes.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <map>
#include <memory>

using scenes::size_cases, scenes::SizeCase, scenes::slip_bits, scenes::Slipping, scenes::slipping;

namespace {

/// True if the ball agrees with a value from another source that is rounded at its last digit.
bool holds(const Ball& x, const char* value) {
    const std::string text = value;
    const auto digits = text.size() - text.find('.') - 1;
    const Ball unit =
        formula::enclosed_constant(scenes::exact("1e-" + std::to_string(digits)), slip_bits);
    const Ball off = abs(Ball(x - formula::enclosed_constant(scenes::exact(text), slip_bits)));
    return x.is_finite() && certainly_less(off, unit);
}

} // namespace

TEST_CASE("sizes of slip zones in balls hold those found by other means") {
    for (const SizeCase& c : size_cases()) {
        CAPTURE(c.name);
        const Slipping s = slipping(c.profile, c.modulus, c.a, "3/10", c.r);
        CHECK(s.slip->size(Edge::right).relative_accuracy_bits() > 250);
        CHECK(s.slip->size(Edge::left).relative_accuracy_bits() > 250);
        CHECK(holds(s.slip->size(Edge::right), c.right));
        CHECK(holds(s.slip->size(Edge::left), c.left));
    }
}

// d/a = 1 - sqrt(1 - tau) (johnson1985), in the two forms that lose no digits at either end.
TEST_CASE("Hertz under Q alone, next to no load and next to full sliding") {
    const Profile hertz = Profile::power_law(scenes::exact("1/70"), scenes::exact("1"));
    for (const char* tau : {"1e-30", "1e-6", "3/4", "1 - 1e-30"}) {
        CAPTURE(tau);
        const Slipping s = slipping(hertz, "7/3", "0.02", tau, "0");
        const Ball t = formula::enclosed_constant(scenes::exact(tau), slip_bits);
        const Ball d = t / (1 + sqrt(1 - t)) / 50;
        for (const Edge edge : {Edge::right, Edge::left}) {
            CHECK(s.slip->size(edge).relative_accuracy_bits() > 180);
            CHECK(overlaps(s.slip->size(edge), d));
        }
        const Ball b = s.slip->stick().b;
        CHECK(overlaps(b, sqrt(1 - t) / 50));
        CHECK(b.relative_accuracy_bits() > 180);
    }
}

// The zone of a wedge tilted by alpha under L: sqrt(a b) = L/(E* phi), b/a = (1 - s)/(1 + s), s =
// sin(pi alpha/(2 phi)); the tension reduces alpha by sigma_0/(2 f E*). Newton's first steps pass
// the corner.
TEST_CASE("a tension moves the stick zone of a tilted wedge to one side of its corner") {
    const Profile wedge = Profile::tilted_wedge(scenes::exact("1/100"), scenes::exact("39/10000"));
    const Ball alpha(Rational(39, 10000), slip_bits);
    const Ball phi(Rational(1, 100), slip_bits);
    for (const char* tau : {"99/100", "1 - 1e-6", "1 - 1e-30"}) {
        CAPTURE(tau);
        const Slipping s = slipping(wedge, "1", "5/2", tau, "-3/4");
        const Ball t = formula::enclosed_constant(scenes::exact(tau), slip_bits);
        const Ball turned = alpha + t * s.force() * Ball(Rational(3, 8), slip_bits);
        const Ball sine = sin(Ball(Ball::pi(slip_bits) * turned / (phi * 2)));
        const Ball mean = s.force() * (1 - t) / phi;
        const Ball ratio = sqrt(Ball((1 + sine) / (1 - sine)));
        CHECK(overlaps(s.slip->stick().a, mean * ratio));
        CHECK(overlaps(s.slip->stick().b, mean / ratio));
        CHECK(s.slip->stick().a.relative_accuracy_bits() > 150);
        CHECK(s.slip->stick().b.relative_accuracy_bits() > 150);
    }
}

// g' = 1/5 up to the corner at the edge, 2/5 beyond it: inside, the contact is a wedge, d = tau a.
TEST_CASE("the edge of the contact on a corner") {
    const formula::Symbols x{"x"};
    const Profile profile = Profile::piecewise_symmetric(
        {scenes::exact("3/4")}, {formula::parse("1/5", x), formula::parse("2/5", x)});
    for (const char* tau : {"1e-9", "1/3", "99/100"}) {
        CAPTURE(tau);
        const Slipping s = slipping(profile, "1", "3/4", tau, "0");
        const Ball t = formula::enclosed_constant(scenes::exact(tau), slip_bits);
        for (const Edge edge : {Edge::right, Edge::left}) {
            CHECK(overlaps(s.slip->size(edge), t * 3 / 4));
            CHECK(s.slip->size(edge).relative_accuracy_bits() > 180);
        }
    }
}

TEST_CASE("the series of the slip zones: Hertz's in closed form, the first term by s_0 and c_0") {
    const Profile hertz = Profile::power_law(scenes::exact("1/70"), scenes::exact("1"));
    const Slipping s = slipping(hertz, "7/3", "0.02", "1/2", "0");
    const auto series = s.slip->series(6);
    // 1 - sqrt(1 - t) = t/2 + t^2/8 + t^3/16 + 5 t^4/128 + 7 t^5/256 + 21 t^6/1024
    const Rational of_a[] = {{1, 2}, {1, 8}, {1, 16}, {5, 128}, {7, 256}, {21, 1024}};
    for (std::size_t k = 0; k < 6; ++k) {
        CHECK(contains(series.right[k] * 50, of_a[k]));
        CHECK(contains(series.left[k] * 50, of_a[k]));
        CHECK(series.right[k].relative_accuracy_bits() > 300);
    }
    for (const SizeCase& c : size_cases()) {
        CAPTURE(c.name);
        const Slipping t = slipping(c.profile, c.modulus, c.a, "3/10", c.r);
        const auto first = t.slip->series(1);
        const ProvedContact& contact = t.contact();
        // Q such that tau = 1: f P.
        const Ball f(Rational(3, 5), slip_bits);
        const Ball Q = f * t.force();
        const ShearLoad<Ball> load{Q,
                                   Q * formula::enclosed_constant(scenes::exact(c.r), slip_bits)};
        for (const Edge edge : {Edge::right, Edge::left}) {
            const Ball s_0 = full_stick_expansion(contact.a() + contact.b(), load, edge, 1)[0];
            const Ball d_1 = s_0 * 2 / (f * contact.expansion(edge, 1)[0]);
            const Ball kappa = edge == Edge::right ? first.right[0] : first.left[0];
            CHECK(overlaps(kappa, d_1));
            CHECK(kappa.relative_accuracy_bits() > 250);
        }
    }
}

// The remainder of n terms is of the order tau^(n + 1), in both directions: it is given by the next
// coefficient.
TEST_CASE("the series of the slip zones approaches their sizes at its order") {
    for (const SizeCase& c : size_cases()) {
        CAPTURE(c.name);
        const Slipping s = slipping(c.profile, c.modulus, c.a, "1e-8", c.r);
        const Ball tau = formula::enclosed_constant(scenes::exact("1e-8"), slip_bits);
        const auto series = s.slip->series(5);
        for (const Edge edge : {Edge::right, Edge::left}) {
            const auto& kappa = edge == Edge::right ? series.right : series.left;
            const Ball rest = (s.slip->size(edge) - slip_sum(kappa, 4, tau)) / pow_int(tau, 5);
            const Ball unit = formula::enclosed_constant(scenes::exact("1e-6"), slip_bits) *
                              (s.slip->whole().length() + abs(kappa[4]));
            CHECK(certainly_less(abs(Ball(rest - kappa[4])), unit));
        }
    }
}

// A Hertz contact's stick zone has half-length c = a sqrt(1 - tau) about -sigma_0 R/(2 f E*)
// (hills-nowell1994): it reaches the left edge at sigma_0 = 2 f E* (a - c)/R.
TEST_CASE("the limits of the bulk tension") {
    const Profile hertz = Profile::power_law(scenes::exact("1/70"), scenes::exact("1"));
    const Slipping s = slipping(hertz, "7/3", "0.02", "3/4", "1/10");
    const Ball limit = Ball(Rational(2 * 3 * 7, 5 * 3 * 70 * 100), slip_bits); // a - c = a/2
    CHECK(overlaps(s.slip->tension_limit(Edge::left), limit));
    CHECK(overlaps(s.slip->tension_limit(Edge::right), -limit));
    CHECK(s.slip->tension_limit(Edge::left).relative_accuracy_bits() > 150);
}

namespace {

EnclosedReach reach_of(const Profile& profile, const char* modulus, const char* a, const char* r,
                       Edge edge, std::size_t n, const char* tolerance, long bits) {
    std::map<long, Slipping> levels;
    SlipReachSearch search(
        [&](long level) -> const BallSlip& {
            auto& s = levels[level];
            if (!s.slip) {
                s = slipping(profile, modulus, a, "1/10", r, level);
            }
            return *s.slip;
        },
        edge, n, scenes::exact(tolerance));
    return search.at(bits);
}

} // namespace

// d_1/d - 1 = -d/(2a): the tolerance is met at d = 2 a tolerance, tau = 4 (tol - tol^2).
TEST_CASE("how far one term stays within a tolerance: Hertz in closed form, never left at a half") {
    const Profile hertz = Profile::power_law(scenes::exact("1/70"), scenes::exact("1"));
    for (const char* tolerance : {"1/100", "1/20", "1/1000000"}) {
        CAPTURE(tolerance);
        const auto reach = reach_of(hertz, "7/3", "0.02", "0", Edge::right, 1, tolerance, 300);
        const Rational t = scenes::exact(tolerance).rational();
        CHECK(reach.leaves);
        CHECK(contains(reach.ratio, Rational(4 * (t - t * t))));
        CHECK(reach.ratio.relative_accuracy_bits() > 180);
    }
    CHECK_FALSE(reach_of(hertz, "7/3", "0.02", "0", Edge::left, 1, "51/100", 300).leaves);
}

// At the end of the reach the error is the tolerance, and it is smaller before; computed from the
// sizes alone.
TEST_CASE("how far the terms stay within a tolerance, tilted and under tension") {
    for (const SizeCase& c : size_cases()) {
        if (c.name.rfind("cubic", 0) == 0) {
            continue; // integrals are in the slow tests
        }
        CAPTURE(c.name);
        for (const Edge edge : {Edge::right, Edge::left}) {
            for (const std::size_t n : {1UL, 3UL}) {
                CAPTURE(n);
                const auto reach = reach_of(c.profile, c.modulus, c.a, c.r, edge, n, "1/100", 256);
                const auto error = [&](const Rational& tau) {
                    const Slipping s = slipping(c.profile, c.modulus, c.a, tau.str(), c.r);
                    const auto series = s.slip->series(n);
                    const auto& kappa = edge == Edge::right ? series.right : series.left;
                    return Ball(slip_sum(kappa, n, s.slip->load_ratio()) / s.slip->size(edge) - 1);
                };
                const Ball bound(Rational(1, 100), slip_bits);
                if (!reach.leaves) {
                    CHECK(certainly_less(abs(error(Rational(99, 100))), bound));
                    continue;
                }
                const Rational end = reach.leaves
                                         ? scenes::exact(reach.ratio.midpoint().str(30)).rational()
                                         : Rational(1);
                const Ball at_end = abs(error(end));
                const Ball unit(Rational(1, Integer(Integer(1) << 80U)), slip_bits);
                CHECK(certainly_less(abs(Ball(at_end - bound)), unit));
                CHECK(certainly_less(abs(error(end / 2)), bound));
                CHECK(certainly_less(abs(error(end * Rational(19, 20))), bound));
            }
        }
    }
}
