// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/precision/error.hpp"

#include <boost/multiprecision/gmp.hpp>
#include <cmath>

namespace edgeproof {

/// An exact rational number, such as the value of a decimal in a file.
using Rational = boost::multiprecision::number<boost::multiprecision::gmp_rational,
                                               boost::multiprecision::et_off>;
using Integer =
    boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;

/// Returns the exact value of a double. Use no other conversion of a double: the one of the library
/// ends the process for a number that is not finite. Throws DomainError for such a number.
[[nodiscard]] inline Rational exact_rational(double x) {
    if (!std::isfinite(x)) {
        throw DomainError("a number is beyond the range of binary64 arithmetic");
    }
    return Rational(x);
}

} // namespace edgeproof
