// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/ball/ball.hpp"
#include "edgeproof/precision/double_word/double_word.hpp"

namespace edgeproof {

/// A double word whose numbers are those of the ball, and more: unknown where the ball is not
/// finite, or its middle is not 0 and not between 2^-900 and 2^900 in size.
[[nodiscard]] DoubleWord to_double_word(const Ball& x);
/// Of a number; the radius is what two words leave out.
[[nodiscard]] DoubleWord to_double_word(const Real& x);

/// A number in two parts, so that a difference with a number beside it keeps its digits.
struct PreciseWord {
    DoubleWord first; ///< without a radius, where it is known
    DoubleWord rest;  ///< below 2^-106 of the first
};
/// Of a ball whose bits are more than those of one double word; unknown as above.
[[nodiscard]] PreciseWord to_precise_word(const Ball& x);

[[nodiscard]] inline DoubleWord operator-(const DoubleWord& x, const PreciseWord& y) {
    return (x - y.first) - y.rest;
}
[[nodiscard]] inline DoubleWord operator-(const PreciseWord& x, const DoubleWord& y) {
    return -(y - x);
}

} // namespace edgeproof
