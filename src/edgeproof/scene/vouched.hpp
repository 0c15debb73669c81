// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/ball.hpp"
#include "edgeproof/precision/text.hpp"

#include <string>

namespace edgeproof {

/// A value with how far it may be from the exact one, and the route that gave it. `proved`: the
/// ball is an enclosure; else its radius is what the route estimates of itself, and is called so.
struct Vouched {
    Ball value;
    bool proved = false;
    std::string route;
};

/// A value as it is printed.
struct PrintedValue {
    std::string text;  ///< correctly rounded at the digits asked for, or at those vouched for
    std::string bound; ///< |text - exact| is at most this: "1.3e-52", or "~1.3e-52" if estimated
    bool complete = false; ///< all the digits that were asked for
};

/// A value that its ball does not tell from zero is "0".
[[nodiscard]] PrintedValue printed(const Vouched& x, unsigned digits);

/// A ball from an estimated absolute error.
[[nodiscard]] Vouched estimated(const Real& value, const Real& error, std::string route);

} // namespace edgeproof
