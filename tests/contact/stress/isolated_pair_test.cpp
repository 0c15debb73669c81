// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/contact/stress/isolated_pair.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

namespace {

constexpr long pair_bits = 200;

Ball pair_ball(const Rational& x) { return {x, pair_bits}; }

/// x^2 + y^2 = 1 and y = slope x.
struct CircleAndLine {
    Rational slope;
    PairOfEquations operator()(const BallPair& at) const {
        const auto& [x, y] = at;
        return {{x * x + y * y - 1, y - x * pair_ball(slope)},
                {{{x * 2, y * 2}, {-pair_ball(slope), pair_ball(1)}}}};
    }
};

} // namespace

TEST_CASE("an isolated pair is the common zero of both equations, narrowly, or nothing") {
    // slope 3/4: (4/5, 3/5), on either side of the origin
    const CircleAndLine near{Rational(3, 4)};
    for (const int side : {1, -1}) {
        const auto at = isolated_pair(near, {pair_ball(side), pair_ball(side)});
        REQUIRE(at);
        CHECK(contains((*at)[0], Rational(4 * side, 5)));
        CHECK(contains((*at)[1], Rational(3 * side, 5)));
        CHECK((*at)[0].relative_accuracy_bits() > pair_bits - 16);
        CHECK((*at)[1].relative_accuracy_bits() > pair_bits - 16);
    }
    // An unknown that keeps its value: x^2 + (3/5)^2 = 1.
    const auto fixed =
        isolated_pair(near, {pair_ball(1), pair_ball(Rational(3, 5))}, {true, false});
    REQUIRE(fixed);
    CHECK(contains((*fixed)[0], Rational(4, 5)));
    CHECK(overlaps((*fixed)[1], pair_ball(Rational(3, 5))));
    // A double zero, and no zero.
    const auto parabola = [](const Rational& height) {
        return [height](const BallPair& at) -> PairOfEquations {
            return {{at[0] * at[0] + pair_ball(height), at[1]},
                    {{{at[0] * 2, pair_ball(0)}, {pair_ball(0), pair_ball(1)}}}};
        };
    };
    CHECK_FALSE(isolated_pair(parabola(0), {pair_ball(1), pair_ball(1)}));
    CHECK_FALSE(isolated_pair(parabola(1), {pair_ball(1), pair_ball(1)}));
}
