// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/precision/rational.hpp"

#include <boost/multiprecision/mpfr.hpp>

namespace edgeproof {

/// A floating-point number of any precision, chosen at run time (mpfr2007). Expression templates
/// are off, so that ternary expressions and `auto` have the type Real.
using Real = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<0>,
                                           boost::multiprecision::et_off>;

/// While it exists, new `Real`s of *this thread* have `digits` decimal digits; its destructor
/// restores the former precision. Other threads are not affected: the library changes only
/// thread-local defaults, and every task of a pool opens its own scope. A `Real` from a scope of
/// higher precision keeps its digits (Boost's default rule). Throws DomainError outside 2 ...
/// 100,000,000 digits.
class PrecisionScope {
public:
    explicit PrecisionScope(unsigned digits);
    ~PrecisionScope();
    PrecisionScope(const PrecisionScope&) = delete;
    PrecisionScope& operator=(const PrecisionScope&) = delete;

private:
    unsigned saved_digits_;
};

/// Returns the number of decimal digits of a new `Real` of this thread.
[[nodiscard]] unsigned working_digits();

/// Returns x rounded to the working precision of this thread.
[[nodiscard]] Real at_working_precision(const Real& x);

} // namespace edgeproof
