// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/rounding/text.hpp"

#include <optional>
#include <string>

namespace edgeproof {

/// A number in decimal, and a bound of its distance from every number in a ball.
struct SeenAtAGlance {
    Decimal value;
    /// bound_text() of that bound; empty if it was not decided.
    std::string bound;
};

/// The result of round_ball() where all digits are certain, found by one multiplication and without
/// the text of either end. A result is proved; without a result the question is open.
[[nodiscard]] std::optional<SeenAtAGlance> rounded_at_a_glance(const Ball& x, unsigned digits,
                                                               Rounding mode);

/// The result of nearest_binary64(), found with a few more bits than binary64 has. Without a result
/// the question is open.
[[nodiscard]] std::optional<double> binary64_at_a_glance(const Ball& x);

/// Returns bound_text() of near * 10^place if that is the same text for every number within a part
/// in 10^11 of it; else empty.
[[nodiscard]] std::string bound_at_a_glance(double near, long place = 0);

/// Lays out a decimal as to_decimal() does.
[[nodiscard]] std::string layout(const Decimal& d, unsigned digits);

} // namespace edgeproof
