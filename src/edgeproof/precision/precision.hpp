// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
/// Numbers. The lowest module: everything above is written in terms of these.
///   error.hpp       the exceptions that the library throws
///   rational.hpp    Rational, Integer: what a decimal in a file means
///   interruption.hpp  work that is asked to end
///   real.hpp        Real (MPFR at any precision) and PrecisionScope
///   arithmetic.hpp  the same few words for double, long double, Float128 and Real
///   text.hpp        exact text in (decimals become rationals), rounded text out
///   ball.hpp        Ball (Arb): a midpoint and a radius that is proved
///   ball_series.hpp BallSeries: truncated power series with balls for coefficients
///   interval.hpp    Interval: from one end to another, where a sign at an end has to be kept
///   digits_right.hpp  how many digits of a number an enclosure shows to be right
///   arb_values.hpp  values of Arb's types that clear themselves
///   elementary.hpp  the arc tangent, sinh x and e^x - 1 of Real, by Arb
///   bounded_cache.hpp  tables that are kept, and do not grow
///   instantiate.hpp  what is compiled for every arithmetic
///   escalate.hpp    precision doubled until an enclosure is narrow enough
#include "edgeproof/precision/arithmetic.hpp"
#include "edgeproof/precision/ball/ball.hpp"
#include "edgeproof/precision/ball/ball_series.hpp"
#include "edgeproof/precision/ball/interval.hpp"
#include "edgeproof/precision/elementary/elementary.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/precision/rational.hpp"
#include "edgeproof/precision/real.hpp"
#include "edgeproof/precision/rounding/digits_right.hpp"
#include "edgeproof/precision/rounding/escalate.hpp"
#include "edgeproof/precision/rounding/text.hpp"
