// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/rational.hpp"

#include <boost/multiprecision/mpfr.hpp>

namespace edgeproof {

/// A floating-point number of any precision, chosen at run time (MPFR).
/// Expression templates are off so that ternaries and `auto` mean what they say.
using Real = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<0>,
                                           boost::multiprecision::et_off>;

/// While it lives, new `Real`s of *this thread* carry `digits` decimal digits; the former
/// precision comes back when it ends, also by an exception. Other threads never see it: the
/// library changes only thread-local defaults, and every task of a pool opens a scope of its own.
/// A `Real` that comes from a scope of higher precision keeps its digits (Boost's default rule).
/// Throws DomainError outside 2 ... 100,000,000 digits.
class PrecisionScope {
public:
    explicit PrecisionScope(unsigned digits);
    ~PrecisionScope();
    PrecisionScope(const PrecisionScope&) = delete;
    PrecisionScope& operator=(const PrecisionScope&) = delete;

private:
    unsigned saved_digits_;
};

/// The decimal digits that a new `Real` of this thread carries now.
[[nodiscard]] unsigned working_digits();

/// x rounded to the working precision of this thread.
[[nodiscard]] Real at_working_precision(const Real& x);

} // namespace edgeproof
