// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/contact/enclosure/rigorous_integral.hpp"
#include "edgeproof/precision/ball/ball_series.hpp"

/// The integrals of an axisymmetric contact, by Arb's rigorous integration (`johansson2018`).
namespace edgeproof::contact {

/// A jump of g' at the radius v > 0 (length), of the size `jump`, and a change of its rate by
/// `rate` (1/length).
struct RingBend {
    const Ball& v;
    const Ball& jump;
    const Ball& rate;
};

/// The part of a bend in pi p/E* at the radius r (docs/axisymmetric.md, "What is integrated"): the
/// integral of h'(s) y/(s sqrt(x^2 + d2)) over 0 < x < X, as a series in the variable of `d2` and
/// `X`, where y^2 = s^2 - v^2.
/// @param bend the bend
/// @param beyond true for r > v: x^2 = s^2 - r^2; false for r < v: x = y
/// @param d2 |r^2 - v^2| (length^2), positive; 0 exactly for r = v, which counts as beyond
/// @param X sqrt(a^2 - r^2), or sqrt(a^2 - v^2) for r < v (length)
/// @param goal the accuracy
[[nodiscard]] BallSeries part_of_bend(const RingBend& bend, bool beyond, const BallSeries& d2,
                                      const BallSeries& X, const IntegralGoal& goal);

} // namespace edgeproof::contact
