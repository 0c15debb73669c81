// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/ball/ball.hpp"
#include "edgeproof/precision/ball/ball_series.hpp"
#include "edgeproof/precision/ball/complex_box.hpp"

#include <cstddef>
#include <functional>

/// The integrals of an axisymmetric contact, by Arb's rigorous integration (`johansson2018`).
namespace edgeproof::contact {

/// A jump of g' at the radius v > 0 (length), of the size `jump`, and a change of its rate by
/// `rate` (1/length).
struct RingBend {
    const Ball& v;
    const Ball& jump;
    const Ball& rate;
};

/// The precision and the accuracy of an integral over 0 < t < 1.
struct IntegralGoal {
    long bits;     ///< working precision
    long accuracy; ///< wanted, in bits
    Ball scale;  ///< the size of the integrand, or 0: that in the middle; the absolute tolerance is
                 ///< 2^-(accuracy + 64) of it
    Ball radius; ///< of convergence of the series (length); only its size matters
};

/// For r > v: the integral of h'(s)/s over 0 < t < 1, s^2 = r^2 + W^2 t^2, as a series in the
/// variable of `r2` and `W`; times W it is the part of the bend in pi p/E* (docs/axisymmetric.md,
/// "What is integrated").
/// @param bend the bend
/// @param goal the accuracy
/// @param r2 r^2 (length^2)
/// @param d2 r^2 - v^2 (length^2), positive; 0 exactly for r = v
/// @param W sqrt(a^2 - r^2) (length)
/// @param moment true: a series of one term, whose integrand has the factor t^2; times W^3 it is
/// the part of the bend in the integral of h'(s) sqrt(s^2 - r^2)
[[nodiscard]] BallSeries outside_bend(const RingBend& bend, const BallSeries& r2,
                                      const BallSeries& d2, const BallSeries& W,
                                      const IntegralGoal& goal, bool moment = false);

/// For r < v: the integral of h'(s) y/(s sqrt(y^2 + v^2 - r^2)) over 0 < t < 1, y = Y t,
/// s^2 = v^2 + y^2; times Y it is the part of the bend in pi p/E*.
/// @param bend the bend
/// @param goal the accuracy
/// @param d2 v^2 - r^2 (length^2), positive
/// @param Y sqrt(a^2 - v^2) (length)
/// @param moment true: a series of one term, whose integrand has the factor y^2 + v^2 - r^2
[[nodiscard]] BallSeries inside_bend(const RingBend& bend, const BallSeries& d2, const Ball& Y,
                                     const IntegralGoal& goal, bool moment = false);

/// The principal root and arctangent (DLMF 4.2.29, 4.23.26); not finite where the box may meet a
/// cut, so that they are holomorphic where they are finite.
[[nodiscard]] Box principal_root(const Box& x);
[[nodiscard]] Box principal_arctangent(const Box& x);
/// A box that is not finite.
[[nodiscard]] Box unknown_box(long bits);

/// The integral of a function that is holomorphic near 0 < t < 1, or whose value is not finite
/// where it is not. `integral_of` is the real part of it.
[[nodiscard]] Ball integral_of(const std::function<Box(const Box& t)>& f, const IntegralGoal& goal);
/// The same for complex values, inside the integrand of another integral: after an interruption the
/// result is not finite, and nothing is thrown, because no exception may pass through Arb.
[[nodiscard]] Box inner_integral_of(const std::function<Box(const Box& t)>& f,
                                    const IntegralGoal& goal);

/// Returns the bits of accuracy that are useful in an integral whose parameters have `known` bits;
/// exact parameters have more than any other number.
[[nodiscard]] long useful_accuracy(long known, long bits);

} // namespace edgeproof::contact
