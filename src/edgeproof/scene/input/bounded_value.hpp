// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/formula/exact/exact.hpp"
#include "edgeproof/precision/ball/ball.hpp"
#include "edgeproof/precision/rounding/text.hpp"

#include <array>
#include <iosfwd>
#include <optional>
#include <string>

namespace edgeproof::scene {

using formula::Exact;

/// A value with a limit of its error and the name of its route. If `proved`, the ball is an
/// enclosure; otherwise its radius is the route's own error estimate.
struct BoundedValue {
    Ball value;
    bool proved = false;
    std::string route;
    std::optional<Rational> exactly = {}; ///< the value itself, if it is a known rational

    /// Returns "closed-form", or "singular-integral (estimate)" if the ball is not proved.
    [[nodiscard]] std::string how() const { return proved ? route : route + " (estimate)"; }
};

/// The format of printed values.
struct Digits {
    unsigned count = 50;
    Rounding rounding = Rounding::nearest;
    bool binary64 = false; ///< also print the nearest binary64
    bool exact = false;    ///< print places that are known exactly as such, also computed ones
};

struct PrintedValue {
    std::string text;  ///< one number: rounded correctly at the digits requested, or at those that
                       ///< are certain; a neighbour if the rounding of a proved value is undecided
    std::string bound; ///< |text - exact| is at most this
    bool complete = false;          ///< all requested digits are given
    bool undecided = false;         ///< no number of bits tried decides the rounding
    std::optional<double> binary64; ///< nothing if the nearest one is undecided
};

/// Returns the name of the route, with a note if the rounding is undecided.
[[nodiscard]] std::string how(const BoundedValue& x, const PrintedValue& p);

/// True if the ball is narrow enough for the digits to be printed.
[[nodiscard]] bool has_digits(const Ball& x, const Digits& digits);

/// True if the value may lie exactly on a limit of rounding, so that no number of bits would
/// decide: the ball is narrow enough for the digits (or contains zero), and yet contains a number
/// of that few digits or a midpoint between two. `has_them`: has_digits of the ball.
[[nodiscard]] bool may_be_a_limit(const Ball& x, const Digits& digits, bool has_them);

/// Formats a value as one number. Rounded to nearest, it is "0" if the ball contains zero.
[[nodiscard]] PrintedValue printed(const BoundedValue& x, const Digits& digits);

/// Formats an exact number that is in no text of the user, such as a point of a range: its decimal,
/// if that has no more digits than requested, else rounded; with `exact`, its own text.
[[nodiscard]] std::string decimal_text(const Exact& x, const Digits& digits);

/// Returns a ball with an estimated absolute error.
[[nodiscard]] BoundedValue estimated(const Real& value, const Real& error, std::string route);

/// Prints a value like a ball, followed by its route: "0.785398 +/- 1.7e-07 (closed-form)". For an
/// estimate, the error is the route's own estimate: "(singular-integral (estimate))".
std::ostream& operator<<(std::ostream& out, const BoundedValue& x);

} // namespace edgeproof::scene
