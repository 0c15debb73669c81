// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/contact/design/best_reach.hpp"
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/contact/enclosure/ball_relative_error.hpp"
#include "edgeproof/formula/parse.hpp"
#include "edgeproof/precision/ball/arb_values.hpp"
#include "edgeproof/precision/rounding/text.hpp"
#include "tests/contact/extents.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <set>
#include <string>

namespace {

using formula::Exact;

formula::Expr in(const std::string& text, const std::set<std::string>& names) {
    return formula::parse(text, formula::Symbols(names));
}

ErrorQuestion about(std::size_t terms = 1, Edge edge = Edge::right) {
    ErrorQuestion q;
    q.terms = terms;
    q.edge = edge;
    return q;
}

bool holds(const Ball& x, const char* decimal, long slack_digits) {
    const Ball exact(Rational(parse_decimal(decimal)), x.bits());
    Rational slack(1);
    for (long k = 0; k < slack_digits; ++k) {
        slack /= 10;
    }
    return certainly_less(abs(x - exact), Ball(slack, x.bits()));
}

/// The first exit over a + b by the search of `edgeproof extent`, which shares no formula with a
/// design.
Ball reach_of_power_law(const Rational& m, std::size_t n, const Rational& tolerance) {
    const EnclosedExtents found = scenes::enclosed<BallContact>(
        {scenes::contact_of("power-law C=1 a=1 m=" + m.str()), Edge::right, n, tolerance.str()},
        256);
    return found.first_exit / found.length;
}

ReachProblem power_law_design(std::size_t n, const Rational& tolerance) {
    ReachProblem problem;
    problem.edges = {power_law_errors(in("m", {"m"}), {}, about(n))};
    problem.tolerance = tolerance;
    return problem;
}

/// No exponent of a scan reaches farther by more than the gap, and those that reach as far are not
/// excluded.
void check_scan(const BestReach& best, const ParameterRange& range, std::size_t n,
                const Rational& tolerance, long steps) {
    for (long k = 0; k <= steps; ++k) {
        const Rational m = range.from + (range.to - range.from) * Rational(k, steps);
        CAPTURE(m.convert_to<double>());
        const Ball reach = reach_of_power_law(m, n, tolerance);
        CHECK(certainly_less(reach, best.shown_reach + Ball(Rational(1, 1'000'000), 256)));
        if (m < best.not_excluded->from || m > best.not_excluded->to) {
            CHECK(certainly_less(reach, best.shown_reach));
        }
    }
    const Ball again = reach_of_power_law(*best.shown_at, n, tolerance);
    CHECK(overlaps(again, best.shown_reach));
    CHECK(again.relative_accuracy_bits() > 100);
}

/// 1/F, F = 2F1(1, b; 3/2; y) with y = 4 z (1 - z), by Arb's own function and DLMF 15.5.2; at the
/// middle only its value, 1/m.
BallSeries reciprocal_by_arb(const Rational& z, const Rational& b, long bits) {
    const Rational y = 4 * z * (1 - z);
    if (y == 1) {
        return {Ball(Rational(1 - 2 * b), bits), jet_terms};
    }
    const Ball one(1, bits);
    BallSeries dy = BallSeries::variable(Ball(z, bits), jet_terms);
    dy = dy * (-dy + one) * Ball(4, bits);
    dy.set(0, Ball(0, bits));
    BallSeries F(Ball(0, bits), jet_terms);
    BallSeries power(one, jet_terms);
    Rational factor(1); // (b)_k/(3/2)_k
    for (unsigned k = 0; k < jet_terms; ++k) {
        F = F + power * (hypergeometric_2f1(Ball(1 + k, bits), Ball(b + k, bits),
                                            Ball(Rational(3, 2) + k, bits), Ball(y, bits)) *
                         Ball(factor, bits));
        factor *= (b + k) / (Rational(3, 2) + k);
        power = power * dy;
    }
    return BallSeries(one, jet_terms) / F;
}

} // namespace

TEST_CASE("design: the exponent for which one term reaches farthest" *
          doctest::test_suite("slow")) {
    const auto errors = power_law_errors(in("m", {"m"}), {}, about());
    ReachProblem problem;
    problem.edges = {errors};
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
    problem.edges = {errors};
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
    problem.edges = {flat};
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
    problem.edges = {right, left};
    problem.tolerance = Rational(1, 100);
    const BestReach upright = best_reach(problem, {Rational(-1, 3), Rational(1, 2)}, {});
    CHECK(upright.kind == BestReach::Kind::two_edges);
    CHECK(upright.proved);
    CHECK(contains(upright.value, Rational(0)));
    CHECK(upright.value.is_finite());
    CHECK(certainly_less(abs(upright.value), Ball(Rational(1, 1'000'000'000'000L), 128)));
}

TEST_CASE("design: the series by the edge is enclosed across the middle of the contact") {
    constexpr long bits = 128;
    const auto between = [](const Rational& lo, const Rational& hi) {
        return Ball::hull(Ball(lo, bits), Ball(hi, bits));
    };
    for (const std::string m : {"1/10", "1/2", "3/4", "1", "3/2", "2", "3"}) {
        const Rational b = (1 - Rational(m)) / 2;
        for (const std::string z : {"1/100", "2/5", "499/1000", "1/2", "501/1000", "7/10"}) {
            CAPTURE(m);
            CAPTURE(z);
            // Even m are poles of Arb's formula, too: it is taken next to them.
            const Rational near = b == Rational(-1, 2) ? b + Rational(1, Integer(1) << 1000U) : b;
            const BallSeries by_arb = reciprocal_by_arb(Rational(z), near, 2600);
            const Ball exact = by_arb[0];
            for (const long digits : {bits, 4 * bits}) {
                const Ball at(Rational(z), digits);
                const Ball of(b, digits);
                const auto off = [&](const Ball& x, const Ball& y) {
                    return abs(x - y) * power_of_two(digits - 28, 128);
                };
                const Ball value = reciprocal_edge_function(at, of);
                CHECK(certainly_less(off(value, exact), Ball(1, 128)));
                CHECK((near != b || overlaps(value, exact))); // an omitted remainder would show
                const BallSeries series = reciprocal_edge_function(
                    BallSeries::variable(at, jet_terms), BallSeries(of, jet_terms));
                for (std::size_t k = 1; k < jet_terms && z != "1/2" && near == b; ++k) {
                    CHECK(certainly_less(off(series[k], by_arb[k]), power_of_two(40, 128)));
                    CHECK(overlaps(series[k], by_arb[k]));
                }
            }
            for (const Rational& h : {Rational(1, 10000), Rational(1, 100)}) {
                const Ball wide = reciprocal_edge_function(
                    between(Rational(z) - h / 2, Rational(z) + h / 3), between(b - h, b + h));
                CHECK(contains(wide, exact.midpoint()));
                CHECK(certainly_less(Ball(wide.radius(), bits), Ball(Rational(1, 2), bits)));
            }
        }
    }
    // At the middle, by the exponent alone: 1/F = m = 1 - 2b.
    const BallSeries half(Ball(Rational(1, 2), bits), jet_terms);
    const BallSeries middle =
        reciprocal_edge_function(half, BallSeries::variable(between(0, Rational(1, 8)), jet_terms));
    CHECK(contains(middle[1], Rational(-2)));
    CHECK(middle[1].is_finite());
    CHECK(contains(middle[2], Rational(0)));
    // For m < 1 there is no derivative with respect to the place.
    CHECK_FALSE(
        reciprocal_edge_function(BallSeries::variable(Ball(Rational(1, 2), bits), jet_terms),
                                 BallSeries(Ball(Rational(1, 8), bits), jet_terms))[1]
            .is_finite());
}

// f at the middle is sqrt(2) m (17/12 - 2m/3) - 1 for two terms, and reaches -1/100 at a root of a
// quadratic equation; beyond it the error passes the middle within the tolerance.
TEST_CASE("design: two terms of a power law reach beyond the middle") {
    const Rational tolerance(1, 100);
    const ReachProblem design = power_law_design(2, tolerance);
    const ParameterRange range{Rational(7812, 10000), Rational(79, 100)};
    const BestReach best = best_reach(design, range, {});
    CHECK(best.kind == BestReach::Kind::touching);
    CHECK(best.proved);
    constexpr long bits = 300;
    const Ball p(Rational(17, 12), bits);
    const Ball m =
        (p - sqrt(p * p - Ball(Rational(8 * 99, 3 * 100), bits) / sqrt(Ball(2, bits)))) * 3 / 4;
    CHECK(overlaps(best.value, m));
    CHECK(best.value.relative_accuracy_bits() > 90);
    REQUIRE(best.touches_at);
    CHECK(contains(*best.touches_at, Rational(1, 2)));
    check_scan(best, range, 2, tolerance, 10);
}

TEST_CASE("design: one and two terms of a power law over all exponents" *
          doctest::test_suite("slow")) {
    const ParameterRange range{Rational(0), Rational(2)};
    const Rational tenth(1, 10);
    const ReachProblem coarse = power_law_design(1, tenth);
    const BestReach best = best_reach(coarse, range, {});
    CHECK(best.proved);
    // One term at the middle: sqrt(2) m - 1 = -1/10.
    CHECK(overlaps(best.value, Ball(Rational(9, 10), 300) / sqrt(Ball(2, 300))));
    const ParameterRange positive{Rational(1, 20), Rational(2)};
    check_scan(best, positive, 1, tenth, 13);
    const Rational hundredth(1, 100);
    const ReachProblem fine = power_law_design(2, hundredth);
    const BestReach two = best_reach(fine, range, {});
    CHECK(two.proved);
    check_scan(two, positive, 2, hundredth, 13);
}

TEST_CASE("design: where the budget ends, all values that are not excluded are named") {
    const ReachProblem design = power_law_design(1, Rational(1, 10));
    const ParameterRange range{Rational(0), Rational(2)};
    const Rational optimum(6363961, 10000000);
    const auto check_hull = [&](const std::optional<ParameterRange>& hull) {
        REQUIRE(hull);
        CHECK(hull->from < optimum);
        CHECK(optimum < hull->to);
        CHECK(hull->to - hull->from < 2);
    };
    DesignOptions few_boxes;
    few_boxes.most_boxes = 24;
    const BestReach best = best_reach(design, range, few_boxes);
    CHECK_FALSE(best.proved);
    CHECK(best.missing.find(" ... ") != std::string::npos);
    check_hull(best.not_excluded);
    // The budget counts evaluations.
    EvaluationCount count{0, 15'000};
    ReachProblem counted = design;
    counted.count = &count;
    const CoveredRange cover = covered_by_exits(counted, range, Rational(56489869, 100000000), {});
    CHECK_FALSE(cover.covered);
    CHECK(count.spent > count.most);
    check_hull(cover.open);
    check_hull(cover.best);
}
