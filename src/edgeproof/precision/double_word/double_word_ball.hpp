// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/ball/ball.hpp"
#include "edgeproof/precision/double_word/double_word.hpp"

namespace edgeproof {

/// Returns a double word that includes all numbers of the ball; unknown if the ball is not finite,
/// or if its midpoint is not 0 and its size is not between 2^-900 and 2^900.
[[nodiscard]] DoubleWord to_double_word(const Ball& x);
/// Returns a number as a double word; the radius is the remainder after two words.
[[nodiscard]] DoubleWord to_double_word(const Real& x);

/// A number in two parts, so that a difference with a number close to it is accurate
/// (docs/double-words.md, lemma 5).
struct PreciseWord {
    DoubleWord first; ///< without a radius, if known
    DoubleWord rest;  ///< below 2^-106 of `first`
};
/// For a ball with more bits than one double word; unknown as above.
[[nodiscard]] PreciseWord to_precise_word(const Ball& x);

[[nodiscard]] inline DoubleWord operator-(const DoubleWord& x, const PreciseWord& y) {
    return (x - y.first) - y.rest;
}
[[nodiscard]] inline DoubleWord operator-(const PreciseWord& x, const DoubleWord& y) {
    return -(y - x);
}

} // namespace edgeproof
