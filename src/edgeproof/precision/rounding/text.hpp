// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/ball/ball.hpp"
#include "edgeproof/precision/rational.hpp"
#include "edgeproof/precision/real.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace edgeproof {

/// The rational number that a decimal ("-0.4", "1e-30"), an integer or a quotient of two integers
/// ("3/2") means, exactly. Throws InputError for anything else: other text, inf, nan, hexadecimal,
/// and exponents beyond 100,000.
[[nodiscard]] Rational parse_decimal(std::string_view text);

/// x to `digits` significant digits, correctly rounded (nearest, ties to even), always the same
/// text for the same number: plain from 1e-5 up to 10^digits, else as d.ddde-NN. Zero is "0".
[[nodiscard]] std::string to_decimal(const Real& x, unsigned digits);

/// An upper bound of x >= 0 in two digits, "1.3e-52"; never smaller than x. Zero is "0".
[[nodiscard]] std::string bound_text(const Real& x);

/// The decimal expansion of q where it ends, else p/q.
[[nodiscard]] std::string exact_text(const Rational& q);

enum class Rounding {
    nearest,
    down, ///< towards minus infinity
    up,   ///< towards plus infinity
    enclosure
};

/// As users write it: "nearest", "down", "up", "enclosure".
[[nodiscard]] std::string_view rounding_name(Rounding mode);
/// Nothing where no way to round has that name.
[[nodiscard]] std::optional<Rounding> rounding_named(std::string_view name);

/// An exact number to `digits` significant digits, rounded as asked and laid out like the above;
/// "[lower, upper]" for an enclosure.
[[nodiscard]] std::string to_decimal(const Rational& q, unsigned digits, Rounding mode);

/// The decimal number 0.d_1 d_2 ... x 10^exponent; 0 where there are no digits.
struct Decimal {
    bool negative = false;
    std::string digits;
    long exponent = 0;
    /// Exactly. Throws InputError for exponents beyond 10,000,000.
    [[nodiscard]] Rational value() const;
    /// The same in a ball of so many bits. Throws as value() does.
    [[nodiscard]] Ball enclosure(long bits) const;
    friend bool operator==(const Decimal&, const Decimal&) = default;
};

/// A number or a ball in decimal.
struct Rounded {
    std::string text;      ///< what every number in the ball rounds to
    unsigned digits = 0;   ///< how many digits of it are certain
    bool complete = false; ///< as many as were asked for
    Decimal lower;         ///< what the text says: one number,
    Decimal upper;         ///< or the ends of an enclosure
};

/// An exact number, rounded as to_decimal does.
[[nodiscard]] Rounded round_rational(const Rational& q, unsigned digits, Rounding mode);

/// The correctly rounded value, at `digits` significant digits, of every number in the ball; where
/// they do not all round alike, as many digits as are certain (none: the text is empty).
/// Rounding::enclosure gives "[lower, upper]", rounded outwards, and is complete when the two
/// differ by at most 2 units in the last digit.
[[nodiscard]] Rounded round_ball(const Ball& x, unsigned digits, Rounding mode = Rounding::nearest);

/// Whether round_ball is complete, told without a text, in a tenth of the time. Yes is proved; no
/// means that it was not seen at a glance: ask round_ball.
[[nodiscard]] bool rounds_alike(const Ball& x, unsigned digits, Rounding mode);

/// The binary64 nearest to every number in the ball, if that is one number (subnormals included;
/// beyond the range: infinities as IEEE 754 rounds to them).
[[nodiscard]] std::optional<double> nearest_binary64(const Ball& x);

/// The binary64 nearest to q, ties to even (subnormals and infinities as above).
[[nodiscard]] double nearest_binary64(const Rational& q);

/// A binary64 as C's %a writes it: exact.
[[nodiscard]] std::string hexadecimal(double x);

} // namespace edgeproof
