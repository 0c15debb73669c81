// SPDX-License-Identifier: GPL-3.0-or-later
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

/// For r > v: the integral of h'(s)/s over 0 < t < 1, s^2 = r^2 + W^2 t^2, as a series in the
/// variable of `r2` and `W`; times W it is the part of the bend in pi p/E* (docs/axisymmetric.md,
/// "What is integrated").
/// @param bend the bend
/// @param goal the accuracy
/// @param r2 r^2 (length^2)
/// @param d2 r^2 - v^2 (length^2), positive; 0 exactly for r = v
/// @param W sqrt(a^2 - r^2) (length)
[[nodiscard]] BallSeries outside_bend(const RingBend& bend, const BallSeries& r2,
                                      const BallSeries& d2, const BallSeries& W,
                                      const IntegralGoal& goal);

/// For r < v: the integral of h'(s) y/(s sqrt(y^2 + v^2 - r^2)) over 0 < t < 1, y = Y t,
/// s^2 = v^2 + y^2; times Y it is the part of the bend in pi p/E*.
/// @param bend the bend
/// @param goal the accuracy
/// @param d2 v^2 - r^2 (length^2), positive
/// @param Y sqrt(a^2 - v^2) (length)
[[nodiscard]] BallSeries inside_bend(const RingBend& bend, const BallSeries& d2, const Ball& Y,
                                     const IntegralGoal& goal);

} // namespace edgeproof::contact
