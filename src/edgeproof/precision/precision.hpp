// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// Numbers. The lowest module, used by all others.
///   error.hpp       the exceptions that the library throws
///   interruption.hpp  requests to end the work
///   real.hpp        Rational, Integer: the exact value of a decimal in a file; Real (MPFR at any
///                   precision) and PrecisionScope
///   text.hpp        exact text in (decimals become rationals), rounded text out; balls printed to
///                   a stream
///   ball.hpp        Ball (Arb): a midpoint and a proved radius
///   ball_series.hpp BallSeries: truncated power series with balls as coefficients
///   arb_values.hpp  values of the types of Arb and FLINT that clear themselves
///   bounded_cache.hpp  tables of bounded size
///   escalate.hpp    precision doubled until an enclosure is narrow enough
#include "edgeproof/precision/ball/ball.hpp"
#include "edgeproof/precision/ball/ball_series.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/precision/real.hpp"
#include "edgeproof/precision/rounding/escalate.hpp"
#include "edgeproof/precision/rounding/text.hpp"
