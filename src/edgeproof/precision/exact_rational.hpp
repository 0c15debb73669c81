// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/rational.hpp"

#include <cmath>

namespace edgeproof {

/// Returns the exact value of a double. Use no other conversion of a double: the one of the library
/// ends the process for a number that is not finite. Throws DomainError for such a number.
[[nodiscard]] inline Rational exact_rational(double x) {
    if (!std::isfinite(x)) {
        throw DomainError("a number is beyond the range of binary64 arithmetic");
    }
    return Rational(x);
}

} // namespace edgeproof
