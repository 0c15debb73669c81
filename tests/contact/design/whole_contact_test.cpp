// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/design/edge_function.hpp"
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/precision/ball/acb_values.hpp"
#include "edgeproof/precision/ball/arb_values.hpp"
#include "tests/contact/design/families.hpp"
#include "tests/contact/extents.hpp"

#include <doctest/doctest.h>

#include <memory>
#include <string>

using namespace edgeproof::families;

namespace {

/// The first exit over a + b by the search of `edgeproof extent`, which shares no formula with a
/// design.
Ball reach_of_power_law(const Rational& m, std::size_t n, const Rational& tolerance) {
    const EnclosedExtents found = scenes::enclosed<BallContact>(
        {scenes::contact_of("power-law C=1 a=1 m=" + m.str()), Edge::right, n, tolerance.str()},
        256);
    return found.first_exit / found.length;
}

struct PowerLawDesign {
    PowerLawDesign(std::size_t n, const Rational& tolerance)
        : errors(power_law_errors(in("m", {"m"}), {}, about(n))) {
        problem.edges = {errors.get()};
        problem.tolerance = tolerance;
    }
    std::unique_ptr<ErrorFamily> errors;
    ReachProblem problem;
};

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

/// F = 2F1(1, b; 3/2; y) by Arb's own function; at the middle 1/m.
Ball reciprocal_by_arb(const Rational& z, const Rational& b, long bits) {
    const Rational y = 4 * z * (1 - z);
    if (y == 1) {
        return Ball(Rational(1 - 2 * b), bits);
    }
    return 1 / hypergeometric_2f1(Ball(1, bits), Ball(b, bits), Ball(Rational(3, 2), bits),
                                  Ball(y, bits));
}

/// Returns 2F1(1 + k, b + k; 3/2 + k; y) by Arb's own function, which chooses among
/// transformations.
Ball by_arb(const Rational& b, const Rational& y, long bits, unsigned k = 0) {
    Ball f(0, bits);
    arb_hypgeom_2f1(f.data(), Ball(Rational(1 + k), bits).data(), Ball(b + k, bits).data(),
                    Ball(Rational(3, 2) + k, bits).data(), Ball(y, bits).data(), 0, bits);
    return f;
}

} // namespace

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
            const Rational near = b == Rational(-1, 2) ? b + Rational(1, Integer(1) << 200U) : b;
            const Ball exact = reciprocal_by_arb(Rational(z), near, 900);
            const Ball value = reciprocal_edge_function(Ball(Rational(z), bits), Ball(b, bits));
            CHECK(certainly_less(abs(value - exact), Ball(Rational(1, Integer(1) << 100U), 128)));
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
    const PowerLawDesign design(2, tolerance);
    const ParameterRange range{Rational(7812, 10000), Rational(79, 100)};
    const BestReach best = best_reach(design.problem, range, {});
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
    const PowerLawDesign coarse(1, tenth);
    const BestReach best = best_reach(coarse.problem, range, {});
    CHECK(best.proved);
    // One term at the middle: sqrt(2) m - 1 = -1/10.
    CHECK(overlaps(best.value, Ball(Rational(9, 10), 300) / sqrt(Ball(2, 300))));
    const ParameterRange positive{Rational(1, 20), Rational(2)};
    check_scan(best, positive, 1, tenth, 13);
    const Rational hundredth(1, 100);
    const PowerLawDesign fine(2, hundredth);
    const BestReach two = best_reach(fine.problem, range, {});
    CHECK(two.proved);
    check_scan(two, positive, 2, hundredth, 13);
}

TEST_CASE("design: where the budget ends, all values that are not excluded are named") {
    const PowerLawDesign design(1, Rational(1, 10));
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
    const BestReach best = best_reach(design.problem, range, few_boxes);
    CHECK_FALSE(best.proved);
    CHECK(best.missing.find(" ... ") != std::string::npos);
    check_hull(best.not_excluded);
    // The budget counts evaluations.
    EvaluationCount count{0, 15'000};
    ReachProblem counted = design.problem;
    counted.count = &count;
    const CoveredRange cover = covered_by_exits(counted, range, Rational(56489869, 100000000), {});
    CHECK_FALSE(cover.covered);
    CHECK(count.spent > count.most);
    check_hull(cover.open);
    check_hull(cover.best);
}

TEST_CASE(
    "the kept sum of the edge's series holds Gauss's function, narrowly, for one b after another") {
    EdgeSum sum;
    for (const long bits : {64L, 200L, 700L}) {
        for (const std::string b : {"0", "1/2", "-1/2", "-1", "-7/3", "99/100", "1/2"}) {
            for (const std::string y : {"1/1000", "1/2", "9/10", "1/7", "-1/3"}) {
                CAPTURE(bits);
                CAPTURE(b);
                CAPTURE(y);
                const Rational exact_b(b);
                const Rational exact_y(y);
                const auto f = sum(Ball(exact_b, bits), Ball(exact_y, bits), 3);
                REQUIRE(f);
                // DLMF 15.5.2, divided by k!. Use many more bits than the sum, so that an omitted
                // part would show.
                Rational factor(1); // (b)_k/(3/2)_k
                for (unsigned k = 0; k < 3; ++k) {
                    const Ball exact =
                        by_arb(exact_b, exact_y, 2 * bits + 100, k) * Ball(factor, 2 * bits + 100);
                    const Ball& at = f->at(k);
                    CAPTURE(k);
                    CHECK(contains(at, exact.midpoint()));
                    CHECK((factor == 0 || at.relative_accuracy_bits() > bits - 40));
                    factor *= (exact_b + k) / (Rational(3, 2) + k);
                }
            }
        }
    }
}

TEST_CASE(
    "the kept sum holds the values at both ends of a wide y, and takes no b that may reach 1") {
    EdgeSum sum;
    const Ball wide = Ball::hull(Ball(Rational(1, 4), 128), Ball(Rational(1, 2), 128));
    const auto f = sum(Ball(Rational(1, 2), 128), wide, 1);
    REQUIRE(f);
    for (const char* y : {"1/4", "2/5", "1/2"}) {
        CHECK(contains((*f)[0], by_arb(Rational(1, 2), Rational(y), 256).midpoint()));
    }
    const auto at_zero = sum(Ball(Rational(1, 2), 128), Ball(0, 128), 1);
    REQUIRE(at_zero);
    CHECK(contains((*at_zero)[0], Rational(1)));
    CHECK_FALSE(sum(Ball(1, 128), Ball(Rational(1, 2), 128), 1));
    CHECK_FALSE(sum(Ball(Rational(1, 2), 128), Ball(Rational(9999, 10000), 128), 1));
    CHECK_FALSE(sum(Ball(Rational(1, 2), 128), Ball(1, 128), 1));
}
