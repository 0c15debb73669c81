// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/ball.hpp"
#include "edgeproof/precision/text.hpp"

#include <optional>
#include <string>

namespace edgeproof {

/// A value with how far it may be from the exact one, and the route that gave it. `proved`: the
/// ball is an enclosure; else its radius is what the route estimates of itself, and is called so.
struct Vouched {
    Ball value;
    bool proved = false;
    std::string route;
    std::optional<Rational> exactly = {}; ///< the value itself, where it is a known rational

    /// "closed-form", or "singular-integral (estimate)" where the ball is no proved one.
    [[nodiscard]] std::string how() const { return proved ? route : route + " (estimate)"; }
};

/// How values are to be written.
struct Digits {
    unsigned count = 50;
    Rounding rounding = Rounding::nearest;
    bool binary64 = false; ///< with the binary64 nearest to each
};

/// A value as it is printed.
struct PrintedValue {
    std::string text;      ///< rounded correctly at the digits asked for, or at those vouched for
    std::string bound;     ///< |text - exact| is at most this; of an enclosure, its width
    bool complete = false; ///< all the digits that were asked for
    std::optional<double> binary64;
};

/// Whether the ball is narrow enough for what is to be printed.
[[nodiscard]] bool settles(const Ball& x, const Digits& digits);

/// A value that its ball does not tell from zero is "0". Rounded down or up, a value that its ball
/// does not tell from a number of that few digits is told by the ball's own end: below or above
/// the exact value all the same.
[[nodiscard]] PrintedValue printed(const Vouched& x, const Digits& digits);

/// A ball from an estimated absolute error.
[[nodiscard]] Vouched estimated(const Real& value, const Real& error, std::string route);

} // namespace edgeproof
