// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/rational.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace edgeproof::io {

/// The interpretation of a text that another program wrote for a number.
struct WrittenNumber {
    enum class Kind { number, nan, infinite, other };
    Kind kind = Kind::other;
    Rational value; ///< the exact value of the text, for Kind::number
};

/// The grammar of numbers that other programs write, for the whole text; letters of either case:
///
///     number      = [sign] (decimal | hexadecimal)
///     decimal     = digits-with-a-point [(E | D) [sign] digits]
///     hexadecimal = 0x hex-digits-with-a-point [P [sign] digits]
///     digits-with-a-point: at least one digit and at most one point, before, between or after them
///     nan         = [sign] nan [(letters, digits, _)]
///     infinite    = [sign] (inf | infinity)
///
/// At most one sign, no blanks. A number beyond 10^(+-100000) or of more than 100,000 digits is
/// Kind::other. Never throws.
[[nodiscard]] WrittenNumber written_number(std::string_view text);

/// Returns the exact value of a number of this grammar; nothing for another text.
[[nodiscard]] std::optional<Rational> read_number(std::string_view text);

/// The digits of a number as it is written.
struct DecimalForm {
    bool exact = false; ///< hexadecimal
    bool with_exponent = false;
    bool zero = true;
    int significant = 0;      ///< digits from the first that is not 0
    int carried = 0;          ///< digits from there to the last that is not 0
    int leading = 0;          ///< the power of ten of the first digit that is not 0
    int decimals = 0;         ///< after the point, without regard to the exponent
    int carried_decimals = 0; ///< of the value, to the last digit that is not 0
};
[[nodiscard]] DecimalForm form_of(std::string_view text);

/// Replaces the comma by a point, if the text is then a decimal of the grammar.
[[nodiscard]] std::optional<std::string> with_decimal_point(std::string_view text);

} // namespace edgeproof::io
