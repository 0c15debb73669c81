// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/contact/law/edge_expansion.hpp"
#include "edgeproof/contact/law/kernels.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <vector>

namespace {

using RationalSeries = Series<Rational>;

/// A mark while an edge moves, in rational numbers: `w` is its root at the start. The angle h is
/// transcendental, but the kernels are linear in it and its derivative is algebraic, so that any
/// rational number can replace its initial value.
Mark<RationalSeries> moving_mark(const Extent<RationalSeries>& e, const Rational& v,
                                 const Rational& w, const Rational& h) {
    const RationalSeries right = e.a - v;
    const RationalSeries left = e.b + v;
    const RationalSeries root = pow_with_constant(RationalSeries(right * left), Rational(1, 2), w);
    // dh = d(right/left) left/root times left/(left + right), from 2 atan sqrt(right/left).
    const RationalSeries quotient = right / left;
    const RationalSeries rate = left * left / (root * (left + right));
    return {right, left, RationalSeries((left - right) / Rational(2)), root,
            antiderivative(RationalSeries(derivative(quotient) * rate.truncated(right.order() - 1)),
                           h)};
}

} // namespace

// Each rate is the derivative of the integrand under the integral sign: w = sqrt((a - v)(v + b))
// has dw/da = sqrt((v + b)/(a - v))/2, and h has dh/da = sqrt((v + b)/(a - v))/(a + b).
TEST_CASE("the kernels over series of rationals: the rates are the derivatives, exactly") {
    const std::size_t order = 6;
    for (const bool right_moves : {true, false}) {
        const RationalSeries a(Rational(5), order);
        const RationalSeries b(Rational(5), order);
        const Extent<RationalSeries> e{
            right_moves ? RationalSeries::variable(Rational(5), order) : a,
            right_moves ? b : RationalSeries::variable(Rational(5), order)};
        // (5 - v)(5 + v) is a square at v = -3 and 4.
        const auto m = moving_mark(e, Rational(-3), Rational(4), Rational(9, 4));
        const auto n = moving_mark(e, Rational(4), Rational(3), Rational(5, 7));
        const auto rate =
            right_moves ? RightRateKernel::between(e, m, n) : LeftRateKernel::between(e, m, n);
        const auto force = derivative(RationalSeries(ForceKernel::between(e, m, n)));
        const auto balance = derivative(RationalSeries(RightBalanceKernel::between(e, m, n)));
        const auto over_length = rate / e.length();
        for (std::size_t k = 0; k + 1 < order; ++k) {
            CAPTURE(k);
            CHECK(force[k] == rate[k] / 2);
            CHECK(balance[k] == (right_moves ? over_length[k] : Rational(-over_length[k])));
        }
        // The same at a knot.
        const Rational weight(3, 11);
        const auto at = derivative(RationalSeries(ForceKernel::at(e, n, weight)));
        const auto rate_at =
            right_moves ? RightRateKernel::at(e, n, weight) : LeftRateKernel::at(e, n, weight);
        for (std::size_t k = 0; k + 1 < order; ++k) {
            CHECK(at[k] == rate_at[k] / 2);
        }
    }
}

// Hertz, E* C = 1: P' = pi a/2; p = sqrt(u (2a - u))/2, so that the brackets have the ratios of the
// coefficients of sqrt(1 - u/2a).
TEST_CASE("the brackets of Hertz over the rationals, exactly") {
    const Rational a(3, 7);
    const std::size_t terms = 12;
    const RationalSeries edge = RationalSeries::variable(a, terms);
    const std::vector<Rational> r = right_edge_brackets(LawSeries<RationalSeries>{edge, edge}, a);
    REQUIRE(r.size() == terms);
    Rational ratio = 1;
    for (std::size_t k = 0; k < terms; ++k) {
        CAPTURE(k);
        CHECK(r[k] == r[0] * ratio);
        const int n = static_cast<int>(k);
        ratio *= Rational(1 - 2 * n, 2 * (n + 1)) / (-2 * a);
    }
    CHECK(r[0] == 2 * a);
}

TEST_CASE("the law of the mirror of the mirror is the law, exactly") {
    const Rational a(7, 5);
    const RationalSeries rate(std::vector<Rational>{Rational(2), Rational(3, 5), Rational(-1, 7),
                                                    Rational(4, 9), Rational(2, 3)});
    const RationalSeries b(std::vector<Rational>{Rational(1, 3), Rational(5, 2), Rational(-2, 3),
                                                 Rational(1, 4), Rational(6, 11)});
    const LawSeries<RationalSeries> law{rate, b};
    const LawSeries<RationalSeries> other = mirrored(law, a);
    const LawSeries<RationalSeries> again = mirrored(other, b[0]);
    REQUIRE(again.force_rate.order() == 4);
    CHECK(other.b[1] == 1 / b[1]);
    CHECK(other.force_rate[0] == rate[0] / b[1]);
    for (std::size_t k = 0; k < 4; ++k) {
        CAPTURE(k);
        CHECK(again.force_rate[k] == rate[k]);
        CHECK(again.b[k] == b[k]);
    }
}
