// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/contact/enclosure/ball_relative_error.hpp"
#include "tests/contact/design/families.hpp"

#include <doctest/doctest.h>

namespace {

using formula::Exact;
using namespace edgeproof::families;

/// Returns g' of Profile::tilted_flat_and_rounded with alpha = 1/10, R = 2 and the flat's
/// half-length t.
ParametricSlope punch_of_flat(const std::string& t) {
    const auto e = [&](const std::string& text) { return in(text, {t}); };
    ParametricSlope s;
    s.knots = {e("-1/5 - 2*" + t), e("-1/5"), e("0")};
    s.pieces = {{e(t), e("1/2")}, {e("-1/10"), e("0")}, {e("0"), e("1/2")}, {e("0"), e("1/2")}};
    s.corners = {false, false, false};
    s.origin = 2;
    return s;
}

/// Compares with the enclosures of contact/enclosure, which share no formula with these.
void check_error(const ErrorFamily& family, const Profile& profile, const Load& load, Edge edge,
                 std::size_t terms, const Rational& parameter) {
    const BallContact contact(profile, Exact::of(1), load, 256);
    const RelativeError f(contact, edge, terms, Exact::of(Rational(1, 100)));
    const auto here = family.over(Ball(parameter, 256));
    for (const Rational& u : {Rational(1, 1000), Rational(1, 7), Rational(3, 5)}) {
        const Rational at = u * exact_value(f.length().midpoint());
        const Ball mine = here.at(Ball(at, 256) / f.length());
        CHECK(overlaps(mine, f.at(at)));
        CHECK(mine.relative_accuracy_bits() > 180);
    }
}

} // namespace

TEST_CASE("design: the error as a function of a parameter is that of the contact") {
    const auto exponent = power_law_errors(in("m", {"m"}), {}, about(3));
    for (const Rational& m : {Rational(2, 3), Rational(1, 10), Rational(5, 2)}) {
        check_error(*exponent, Profile::power_law(Exact::of(1), Exact::of(m)),
                    Load::right_edge(Exact::of(1)), Edge::right, 3, m);
    }
    for (const Edge edge : {Edge::right, Edge::left}) {
        for (const bool by_force : {false, true}) {
            ParametricLoad load;
            load.contact_modulus = in("1", {});
            (by_force ? load.P : load.a) = in("1/4", {});
            const auto flat = linear_slope_errors(punch_of_flat("t"), load, about(2, edge));
            const Exact quarter = Exact::of(Rational(1, 4));
            check_error(*flat,
                        Profile::tilted_flat_and_rounded(Exact::parse("1/10"), Exact::parse("1/3"),
                                                         Exact::of(2)),
                        by_force ? Load::force(quarter) : Load::right_edge(quarter), edge, 2,
                        Rational(1, 3));
            check_jet(*flat, Rational(1, 6), Rational(1, 3));
        }
    }
    check_jet(*exponent, Rational(1, 6), Rational(2, 3));
    check_jet(*exponent, Rational(2, 5), Rational(2, 3));
    check_jet(*full_stick_errors(in("1", {}), in("s", {"s"}), in("2", {}), about(2)),
              Rational(1, 3), Rational(1, 2));
}

TEST_CASE("design: the exponent for which one term reaches farthest" *
          doctest::test_suite("slow")) {
    const auto errors = power_law_errors(in("m", {"m"}), {}, about());
    ReachProblem problem;
    problem.edges = {errors.get()};
    problem.tolerance = Rational(1, 100);
    problem.part = Rational(1, 2);
    const ParameterRange range{Rational(0), Rational(2)};
    const BestReach best = best_reach(problem, range, {});
    CHECK(best.kind == BestReach::Kind::touching);
    CHECK_FALSE(best.attained);
    CHECK(best.proved);
    // mpmath, 45 digits: findroot of f = 1/100, diff(f, z) = 0 for f = 1/(sqrt(1-z) hyp2f1(1,
    // (1-m)/2, 3/2, 4 z (1-z))) - 1 from (0.2, 0.668); then of f = -1/100 for that m.
    CHECK(holds(best.value, "0.667966665381445967911229231567434349204007852", 30));
    CHECK(holds(*best.touches_at, "0.264665388678795518665902599586076291115720002", 30));
    CHECK(holds(best.reach, "0.450166365173778823621275309344928449066977652", 30));
    // The same for the printed exponent.
    CHECK(holds(proved_reach(problem, Ball(Rational(5, 8), 256)).reach,
                "0.274333139081381532225988320384348082406814031", 30));
    // The reach that is shown does not exceed the stated one, but almost equals it.
    CHECK(holds(best.shown_reach, "0.450166365173778823621275309344928449066977652", 7));
    // A reach below the best one is not proved.
    DesignOptions few;
    few.most_boxes = 2000;
    CHECK_FALSE(covered_by_exits(problem, range, Rational(45, 100), few).covered);
}

TEST_CASE("design: the tension for which one term of the shear reaches farthest") {
    // Let Q = 1, a + b = 2 and kappa = B/A. Then f + 1 = sqrt(1 - z)/(1 - kappa z), whose maximum
    // is 1/(2 sqrt(kappa (1 - kappa))) at z = 2 - 1/kappa: it equals 1 + eps for kappa = (1 +
    // sqrt(1 - (1 + eps)^-2))/2, and sigma_0 = kappa/pi/(1/2 - kappa/4).
    const auto errors = full_stick_errors(in("1", {}), in("s", {"s"}), in("2", {}), about());
    ReachProblem problem;
    problem.edges = {errors.get()};
    problem.tolerance = Rational(1, 100);
    const BestReach best = best_reach(problem, {Rational(0), Rational(2)}, {});
    CHECK(best.kind == BestReach::Kind::touching);
    CHECK(best.proved);
    constexpr long bits = 300;
    const Ball one_hundredth(Rational(101, 100), bits);
    const Ball kappa = (sqrt(1 - 1 / (one_hundredth * one_hundredth)) + 1) / 2;
    const Ball tension = kappa / Ball::pi(bits) / (Ball(Rational(1, 2), bits) - kappa / 4);
    CHECK(overlaps(best.value, tension));
    CHECK(overlaps(*best.touches_at, 2 - 1 / kappa));
    CHECK(best.value.relative_accuracy_bits() > 100);
    // f = -eps: (1 - z) = (1 - eps)^2 (1 - kappa z)^2, a quadratic equation in z.
    const Ball c(Rational(99 * 99, 10000), bits);
    const Ball p = c * kappa * kappa;
    const Ball q = 1 - c * kappa * 2;
    const Ball z = (sqrt(q * q + p * (1 - c) * 4) - q) / (p * 2);
    CHECK(overlaps(best.reach, z));
}

TEST_CASE("design: an end of the range, and both edges" * doctest::test_suite("slow")) {
    // Hertz is the best of all flat-and-rounded pads for one term at 5 %: f = (1 - z)^(-1/2) - 1 is
    // 1/20 at z = 1 - (20/21)^2.
    const auto e = [](const std::string& text) { return in(text, {"t"}); };
    ParametricSlope pad;
    pad.knots = {e("-t"), e("0"), e("t")};
    pad.pieces = {{e("t"), e("1")}, {e("0"), e("0")}, {e("0"), e("0")}, {e("-t"), e("1")}};
    pad.corners = {false, false, false};
    pad.origin = 1;
    pad.symmetric = true;
    ParametricLoad load;
    load.a = in("1", {});
    load.contact_modulus = in("1", {});
    const auto flat = linear_slope_errors(pad, load, about());
    ReachProblem problem;
    problem.edges = {flat.get()};
    problem.tolerance = Rational(1, 20);
    const BestReach best = best_reach(problem, {Rational(0), Rational(4, 5)}, {});
    CHECK(best.kind == BestReach::Kind::end_of_range);
    CHECK(best.proved);
    CHECK(contains(best.reach, Rational(41, 441)));
    // A wedge of tilt alpha, both edges: by symmetry the upright one is best, with equal reach at
    // both.
    ParametricSlope wedge;
    wedge.knots = {in("0", {})};
    wedge.pieces = {{in("-(1 + s)", {"s"}), in("0", {})}, {in("1 - s", {"s"}), in("0", {})}};
    wedge.corners = {true};
    const auto right = linear_slope_errors(wedge, load, about(1, Edge::right));
    const auto left = linear_slope_errors(wedge, load, about(1, Edge::left));
    problem.edges = {right.get(), left.get()};
    problem.tolerance = Rational(1, 100);
    const BestReach upright = best_reach(problem, {Rational(-1, 3), Rational(1, 2)}, {});
    CHECK(upright.kind == BestReach::Kind::two_edges);
    CHECK(upright.proved);
    CHECK(contains(upright.value, Rational(0)));
    CHECK(upright.value.is_finite());
    CHECK(certainly_less(abs(upright.value), Ball(Rational(1, 1'000'000'000'000L), 128)));
}
