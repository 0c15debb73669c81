// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/precision/ball/ball.hpp"
#include "edgeproof/precision/real.hpp"

#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>

namespace edgeproof {

/// Returns the exact rational value of a decimal ("-0.4", "1e-30"), an integer or a quotient of two
/// integers ("3/2"). Throws InputError for anything else: other text, inf, nan, hexadecimal, and
/// exponents beyond 100,000.
[[nodiscard]] Rational parse_decimal(std::string_view text);

/// Returns x to `digits` significant digits, correctly rounded (nearest, ties to even), always the
/// same text for the same number: plain from 1e-5 up to 10^digits, else as d.ddde-NN. Zero is "0".
[[nodiscard]] std::string to_decimal(const Real& x, unsigned digits);

/// Returns an upper bound of x >= 0 in two digits, "1.3e-52". Zero is "0".
[[nodiscard]] std::string bound_text(const Real& x);

/// Returns the decimal expansion of q if it terminates, else p/q.
[[nodiscard]] std::string exact_text(const Rational& q);

enum class Rounding {
    nearest,
    down, ///< towards minus infinity
    up    ///< towards plus infinity
};

/// The name used in input and output: "nearest", "down", "up".
[[nodiscard]] std::string_view rounding_name(Rounding mode);
/// Nothing if no rounding has that name.
[[nodiscard]] std::optional<Rounding> rounding_named(std::string_view name);

/// Returns an exact number to `digits` significant digits, rounded by `mode` and laid out as above.
[[nodiscard]] std::string to_decimal(const Rational& q, unsigned digits, Rounding mode);

/// The decimal number 0.d_1 d_2 ... x 10^exponent; 0 if there are no digits.
struct Decimal {
    bool negative = false;
    std::string digits;
    long exponent = 0;
    /// The exact value. Throws InputError for exponents beyond 10,000,000.
    [[nodiscard]] Rational value() const;
    /// The same in a ball of `bits` bits. Throws like value().
    [[nodiscard]] Ball enclosure(long bits) const;
    friend bool operator==(const Decimal&, const Decimal&) = default;
};

/// The decimal expansion of q, with a last digit that is not 0, if it terminates.
[[nodiscard]] std::optional<Decimal> terminating_decimal(const Rational& q);

/// A number or a ball in decimal.
struct Rounded {
    std::string text;      ///< the text to which every number in the ball rounds
    unsigned digits = 0;   ///< number of digits that are certain
    bool complete = false; ///< as many digits as requested are certain
    Decimal value;         ///< the number of the text
};

/// An exact number, rounded as to_decimal does.
[[nodiscard]] Rounded round_rational(const Rational& q, unsigned digits, Rounding mode);

/// Returns the correctly rounded value, to `digits` significant digits, of every number in the
/// ball. If they do not all round alike, it has as many digits as are certain (if there are none,
/// the text is empty).
[[nodiscard]] Rounded round_ball(const Ball& x, unsigned digits, Rounding mode = Rounding::nearest);

/// Returns the binary64 nearest to every number in the ball, if that is one number (including
/// subnormals; beyond the range infinities as IEEE 754 rounds to them).
[[nodiscard]] std::optional<double> nearest_binary64(const Ball& x);

/// Returns q truncated after `bits` bits, with the last bit set to 1 if anything was truncated
/// (rounding to odd). Rounding this to a shorter format gives the same as rounding q.
[[nodiscard]] Real rounded_to_odd(const Rational& q, long bits);

/// Returns the binary64 nearest to q, ties to even (subnormals and infinities as above).
[[nodiscard]] double nearest_binary64(const Rational& q);

/// Prints a ball as "0.785398 +/- 1.7e-07": its number, rounded correctly to as many significant
/// digits as the precision of the stream (std::setprecision; 6 by default), or to those that are
/// certain, and the bound of |that number - x| for every x in the ball, rounded up. A ball without
/// a certain digit is printed as "[lower, upper]", one that is not finite as "nan".
std::ostream& operator<<(std::ostream& out, const Ball& x);

/// Returns -log10 |x/exact - 1| for the number of the ball that is worst for x, limited by the bits
/// of both. 0 for negative values, for a NaN, and if the ball contains zero and x is not zero.
[[nodiscard]] double digits_reached(const Real& x, const Ball& exact);

} // namespace edgeproof
