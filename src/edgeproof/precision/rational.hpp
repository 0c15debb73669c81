// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <boost/multiprecision/gmp.hpp>

namespace edgeproof {

/// An exact rational number, such as the value of a decimal in a file.
using Rational = boost::multiprecision::number<boost::multiprecision::gmp_rational,
                                               boost::multiprecision::et_off>;
using Integer =
    boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;

} // namespace edgeproof
