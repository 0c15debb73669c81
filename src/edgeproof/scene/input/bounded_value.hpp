// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/ball/ball.hpp"
#include "edgeproof/precision/rounding/text.hpp"

#include <array>
#include <optional>
#include <string>

namespace edgeproof::scene {

/// A value with how far it may be from the exact one, and the route that gave it. `proved`: the
/// ball is an enclosure; else its radius is what the route estimates of itself, and is called so.
struct BoundedValue {
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
    std::string text;       ///< rounded correctly at the digits asked for, or at those certain;
                            ///< "[lower, upper]" where the rounding of a proved value is
                            ///< undecided, and where the value may be zero
    std::string bound;      ///< |text - exact| is at most this; of an enclosure, its width
    bool complete = false;  ///< all the digits that were asked for
    bool undecided = false; ///< no bits tried tell on which side of a limit of rounding it lies
    std::optional<double> binary64;
    std::array<double, 2> binary64_between{}; ///< where the nearest one is undecided
};

/// How the value came about, and that its rounding is undecided where it is.
[[nodiscard]] std::string how(const BoundedValue& x, const PrintedValue& p);

/// Whether the ball is narrow enough for what is to be printed.
[[nodiscard]] bool has_digits(const Ball& x, const Digits& digits);

/// Whether the ball has the digits that are to be printed, or cannot be told from zero, and yet
/// does not tell the value from a number of that few digits, or from half-way between two: there
/// the value may be exactly that, and then no number of bits tells. `has_them`: has_digits of it.
[[nodiscard]] bool may_be_a_limit(const Ball& x, const Digits& digits, bool has_them);

/// "0" is a value that is known to be zero. One whose ball contains zero and other numbers, and any
/// other proved value of which the ball does not decide the rounding, is its enclosure.
[[nodiscard]] PrintedValue printed(const BoundedValue& x, const Digits& digits);
/// Its text alone.
[[nodiscard]] std::string printed_text(const BoundedValue& x, const Digits& digits);

/// A ball from an estimated absolute error.
[[nodiscard]] BoundedValue estimated(const Real& value, const Real& error, std::string route);

} // namespace edgeproof::scene
