// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/rational.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace edgeproof::conformance {

/// What a text that another program wrote for a number is.
struct WrittenNumber {
    enum class Kind { number, nan, infinite, other };
    Kind kind = Kind::other;
    Rational value; ///< exactly what is written, for Kind::number
};

/// The one grammar of numbers in answers, the whole text or nothing; letters of either case:
///
///     number      = [sign] (decimal | hexadecimal)
///     decimal     = digits-with-a-point [(E | D) [sign] digits]
///     hexadecimal = 0x hex-digits-with-a-point [P [sign] digits]
///     digits-with-a-point: at least one digit and at most one point, before, between or behind
///     nan         = [sign] nan [(letters, digits, _)]
///     infinite    = [sign] (inf | infinity)
///
/// One sign at most, no blanks. A number beyond 10^(+-100000) or of more than 100,000 digits is
/// Kind::other. Never throws.
[[nodiscard]] WrittenNumber written_number(std::string_view text);

/// The text with a point for the comma, where it is such a decimal but for the comma.
[[nodiscard]] std::optional<std::string> with_decimal_point(std::string_view text);

} // namespace edgeproof::conformance
