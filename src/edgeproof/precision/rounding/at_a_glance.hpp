// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/rounding/text.hpp"

#include <optional>
#include <string>

namespace edgeproof {

/// A number in decimal, and how far it is at most from any number in a ball.
struct SeenAtAGlance {
    Decimal value;
    /// As bound_text() of the farthest; empty where that was not seen.
    std::string bound;
};

/// What round_ball() finds, all digits certain, by a multiplication and no text of either end.
/// What it gives is proved; nothing means that it was not seen so.
[[nodiscard]] std::optional<SeenAtAGlance> rounded_at_a_glance(const Ball& x, unsigned digits,
                                                               Rounding mode);

/// What nearest_binary64() finds, by a few bits more than binary64 has. In the same sense.
[[nodiscard]] std::optional<double> binary64_at_a_glance(const Ball& x);

/// bound_text() of near * 10^place, and of every number within a part in 10^11 of it, where that is
/// one text; else empty.
[[nodiscard]] std::string bound_at_a_glance(double near, long place = 0);

/// As to_decimal() lays out.
[[nodiscard]] std::string layout(const Decimal& d, unsigned digits);

} // namespace edgeproof
