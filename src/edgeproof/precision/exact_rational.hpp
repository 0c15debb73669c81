// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/rational.hpp"

#include <cmath>

namespace edgeproof {

/// The value of a double, exactly. No other conversion of a double is to be used: that of the
/// library ends the process for a number that is not finite. Throws DomainError for one.
[[nodiscard]] inline Rational exact_rational(double x) {
    if (!std::isfinite(x)) {
        throw DomainError("a number is beyond the range of binary64 arithmetic");
    }
    return Rational(x);
}

} // namespace edgeproof
