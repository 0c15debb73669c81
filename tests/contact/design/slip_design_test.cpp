// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/contact/design/families.hpp"
#include "tests/contact/slip_scenes.hpp"

#include <memory>

using namespace edgeproof::families;

namespace {

ParametricLoad to_edge(const std::string& a) {
    ParametricLoad load;
    load.a = in(a, {});
    load.contact_modulus = in("1", {});
    return load;
}

/// Returns g' of a cylinder of radius 1.
ParametricSlope cylinder() {
    ParametricSlope s;
    s.knots = {in("0", {})};
    s.pieces = {{in("0", {}), in("1", {})}, {in("0", {}), in("1", {})}};
    s.corners = {false};
    s.symmetric = true;
    return s;
}

/// Returns slopes -1 and 1, with the corner rounded to a parabola over -r < x < r, times r.
ParametricSlope rounded_wedge() {
    const auto e = [](const std::string& text) { return in(text, {"r"}); };
    ParametricSlope s;
    s.knots = {e("-r"), e("0"), e("r")};
    s.pieces = {{e("-r"), e("0")}, {e("0"), e("1")}, {e("0"), e("1")}, {e("r"), e("0")}};
    s.corners = {false, false, false};
    s.origin = 1;
    s.symmetric = true;
    return s;
}

/// Returns g' of Profile::tilted_flat_and_rounded, t = 1, R = 2.
ParametricSlope tilted_punch() {
    const auto e = [](const std::string& text) { return in(text, {"alpha"}); };
    ParametricSlope s;
    s.knots = {e("-2*alpha - 2"), e("-2*alpha"), e("0")};
    s.pieces = {{e("1"), e("1/2")}, {e("-alpha"), e("0")}, {e("0"), e("1/2")}, {e("0"), e("1/2")}};
    s.corners = {false, false, false};
    s.origin = 2;
    return s;
}

} // namespace

// The enclosures of contact/enclosure find the stick zone by other formulas.
TEST_CASE("slip zones over a range of a parameter are those of the contact") {
    const std::string tilt = "1/10";
    const Rational alpha(1, 10);
    const Profile punch = Profile::tilted_flat_and_rounded(scenes::exact(tilt), scenes::exact("1"),
                                                           scenes::exact("2"));
    const std::optional<formula::Expr> tensions[] = {std::nullopt, in("1/20", {})};
    for (const auto& tension : tensions) {
        for (const Edge edge : {Edge::right, Edge::left}) {
            for (const std::size_t n : {1UL, 3UL}) {
                CAPTURE(n);
                const auto family = linear_slip_errors(tilted_punch(), to_edge("3/2"), tension,
                                                       about("alpha", n, edge));
                const auto here = family->over({Ball(alpha, 300)});
                for (const char* tau : {"1/1000", "3/10", "4/5"}) {
                    const auto s = scenes::slipping(punch, "1", "3/2", tau, tension ? "1/20" : "0");
                    const auto series = s.slip->series(n);
                    const Ball sum = slip_sum(edge == Edge::right ? series.right : series.left, n,
                                              s.slip->load_ratio());
                    const Ball at = here.at(Ball(scenes::exact(tau).rational(), 300));
                    CHECK(overlaps(at, sum / s.slip->size(edge) - 1));
                    CHECK(at.relative_accuracy_bits() > 180);
                }
                check_jet(*family, Rational(3, 10), alpha);
            }
        }
    }
    check_jet(*power_law_slip_errors(in("m", {"m"}), about("m", 2)), Rational(1, 3),
              Rational(5, 8));
    // The enclosure over a wide ball contains the one at a point, also at zero load and at full
    // sliding.
    const auto family = linear_slip_errors(rounded_wedge(), to_edge("1"), {}, about("r"));
    const auto point = family->over({Ball(Rational(1, 2), 128)});
    const auto box =
        family->over({Ball::hull(Ball(Rational(49, 100), 128), Ball(Rational(51, 100), 128))});
    for (const auto& [lo, tau, hi] :
         {std::array<Rational, 3>{0, Rational(1, 1000), Rational(1, 500)},
          std::array<Rational, 3>{Rational(1, 4), Rational(2, 7), Rational(1, 3)},
          std::array<Rational, 3>{Rational(4, 5), Rational(9, 10), 1}}) {
        const Ball at = point.at(Ball(tau, 128));
        const Ball wide = Ball::hull(Ball(lo, 128), Ball(hi, 128));
        CHECK(point.at(wide).is_finite());
        CHECK(contains(point.at(wide), at));
        CHECK(contains(box.at(wide), at));
    }
}

// d/a = 1 - (1 - tau)^(1/(m + 1)): one term is worst for the greatest m, and exact for a wedge.
TEST_CASE("design of a slip load: the ends of a range of exponents") {
    const auto errors = power_law_slip_errors(in("m", {"m"}), about("m"));
    ReachProblem problem;
    problem.edges = {errors.get()};
    problem.tolerance = Rational(1, 20);
    const BestReach best = best_reach(problem, {{Rational(1), Rational(4)}}, {});
    CHECK(best.kind == BestReach::Kind::end_of_range);
    CHECK(best.proved);
    CHECK(contains(best.reach, Rational(19, 100))); // 4 (tol - tol^2)
    const BestReach wedge = best_reach(problem, {{Rational(0), Rational(4)}}, {});
    CHECK(wedge.kind == BestReach::Kind::everywhere);
    CHECK(wedge.proved);
    CHECK(contains(wedge.reach, Rational(1)));
}

// mpmath, 55 digits: with F(s) = pi s^2/2 for s < r and r sqrt(s^2 - r^2) + s^2 asin(r/s) beyond,
// P = F(1), F' = 2 s asin(r/s), the error of one term is (P - F(s))/(F'(1) (1 - s)) - 1. findroot
// of error = 1/10 and d error/ds = 0, which is P - F = pi s (1 - s), from s = 0.86, r = 0.955; then
// of error = -1/10 from s = 0.45.
TEST_CASE("design of a slip load: how much of a wedge to round" * doctest::test_suite("slow")) {
    const auto errors = linear_slip_errors(rounded_wedge(), to_edge("1"), {}, about("r"));
    ReachProblem problem;
    problem.edges = {errors.get()};
    problem.tolerance = Rational(1, 10);
    const BestReach best = best_reach(problem, {{Rational(9, 10), Rational(99, 100)}}, {});
    CHECK(best.kind == BestReach::Kind::touching);
    CHECK(best.proved);
    CHECK(holds(best.value[0], "0.9614971793256811714098522879564050252621776656", 30));
    REQUIRE(best.touches_at);
    CHECK(holds(*best.touches_at, "0.1734432441434477105977716887819184960823007733", 30));
    CHECK(holds(best.reach, "0.7487565021203062663026753510143166608576977568", 30));
}

// A cylinder under tension, rho = sigma_0/Q: with y = 1 - sqrt(1 - tau) and K = rho P/2, the sizes
// are d = y + K tau, d_1 = tau/2 + K tau and tau = y (2 - y), so that d_1/d - 1 = -tol where
// y = tol (1 + 2 K)/(1/2 + tol K). It grows with rho: rho = s (1 - s) has its maximum at 1/2.
TEST_CASE("design of a slip load: a smooth maximum" * doctest::test_suite("slow")) {
    const auto errors =
        linear_slip_errors(cylinder(), to_edge("1"), in("s*(1 - s)", {"s"}), about("s"));
    ReachProblem problem;
    problem.edges = {errors.get()};
    problem.tolerance = Rational(1, 100);
    const BestReach best = best_reach(problem, {{Rational(1, 10), Rational(4, 5)}}, {});
    CHECK(best.kind == BestReach::Kind::smooth);
    CHECK(best.attained);
    CHECK(best.proved);
    CHECK(contains(best.value[0], Rational(1, 2)));
    CHECK(best.value[0].relative_accuracy_bits() > 90);
    const Ball tolerance(Rational(1, 100), 300);
    const Ball K = Ball::pi(300) / 32;
    const Ball y = tolerance * (1 + K * 2) / (Ball(Rational(1, 2), 300) + tolerance * K);
    CHECK(overlaps(best.reach, y * (2 - y)));
    CHECK(best.reach.relative_accuracy_bits() > 90);
}

// Full stick, Q = sigma_0 = 1, at the left edge: A = 1/pi - D/8, B = -D/4, kappa = B/A, and one
// term is 1 % too small where sqrt(1 - z) = (99/100) (1 - kappa z). A wider contact has a longer
// unit of length and a greater |kappa|. mpmath, 60 digits: findroot of diff(D z(D)) from 0.85, z by
// the quadratic formula.
TEST_CASE("design: a smooth maximum of a distance") {
    ErrorQuestion question = about("D", 1, Edge::left);
    question.unit = ReachUnit::distance;
    const auto errors = full_stick_errors(in("1", {}), in("1", {}), in("D", {"D"}), question);
    ReachProblem problem;
    problem.edges = {errors.get()};
    problem.tolerance = Rational(1, 100);
    const BestReach best = best_reach(problem, {{Rational(1, 10), Rational(2)}}, {});
    CHECK(best.kind == BestReach::Kind::smooth);
    CHECK(best.proved);
    CHECK(holds(best.value[0], "0.8526221388392013900482973643985113122000118704", 30));
    CHECK(holds(best.reach, "0.0056936635236393989213759396176520720243406397", 30));
}

// At alpha = 0.3664... the left edge passes the end of the flat. The expected values are those for
// exact parameters on both sides.
TEST_CASE("design: a knot passes an edge within a box") {
    for (const Edge edge : {Edge::right, Edge::left}) {
        const auto errors =
            linear_slope_errors(tilted_punch(), to_edge("3/2"), about("alpha", 1, edge));
        const auto box = errors->over(
            {Ball::hull(Ball(Rational(36647, 100000), 128), Ball(Rational(36648, 100000), 128))});
        for (const Rational& u : {Rational(1, 100), Rational(1, 3), Rational(9, 10)}) {
            const Ball over = box.at(Ball(u, 128));
            CHECK(over.is_finite());
            for (const long k : {3664700L, 3664764L, 3664765L, 3664766L, 3664800L}) {
                const Rational alpha(k, 10000000);
                const auto contact = BallContact(
                    Profile::tilted_flat_and_rounded(formula::Exact::of(alpha), scenes::exact("1"),
                                                     scenes::exact("2")),
                    scenes::exact("1"), Load::right_edge(scenes::exact("3/2")), 256);
                const RelativeError f(contact, edge, 1, scenes::exact("1/100"));
                const Ball at(u, 256);
                const Ball p = contact.pressure(edge, at * f.length());
                const Ball local = contact.expansion(edge, 1)[0] * sqrt(at * f.length());
                CHECK(contains(over, local / p - 1));
            }
        }
    }
}
