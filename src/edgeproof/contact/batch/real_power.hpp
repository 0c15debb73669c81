// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/formula/exact/exact.hpp"
#include "edgeproof/precision/real.hpp"

#include <vector>

namespace edgeproof::contact {

/// Computes x^e for one exponent and many x > 0, at the working precision of the thread that
/// created the object, to within some units in the last place. If the exponent is a quotient of
/// small integers, Newton's iteration for the inverse root takes a few products instead of a
/// logarithm and an exponential. Other exponents use Arb.
class RealPower {
public:
    /// `exponent` is e.
    explicit RealPower(const formula::Exact& exponent);

    /// Computes `out` = x^e for x > 0.
    void operator()(Real& out, const Real& x);
    [[nodiscard]] const Real& exponent() const noexcept { return exponent_; }

private:
    struct Step {
        Real x;
        Real y;
        Real product;
    };
    /// Computes `out` = y^n for n >= 1.
    void raise(Real& out, const Real& y, unsigned long n);

    Real exponent_;
    bool by_root_ = false;
    long numerator_ = 0;
    unsigned long denominator_ = 1;
    std::vector<Step> steps_; ///< with growing precision
    Real square_;
    Real root_power_;
};

} // namespace edgeproof::contact
