// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/formula/exact/exact.hpp"
#include "edgeproof/precision/real.hpp"

#include <vector>

namespace edgeproof::contact {

/// x^e for one exponent and many x > 0, at the working precision of the thread that made it, within
/// some units of the last bit: by Newton's iteration for the inverse root where the exponent is a
/// quotient of small numbers (a handful of products instead of a logarithm and an exponential), by
/// Arb otherwise.
class RealPower {
public:
    explicit RealPower(const formula::Exact& exponent);

    void operator()(Real& out, const Real& x);
    [[nodiscard]] const Real& exponent() const noexcept { return exponent_; }

private:
    struct Step {
        Real x;
        Real y;
        Real product;
    };
    void raise(Real& out, const Real& y, unsigned long n);

    Real exponent_;
    bool by_root_ = false;
    long numerator_ = 0;
    unsigned long denominator_ = 1;
    std::vector<Step> steps_; ///< of growing precision
    Real square_;
    Real root_power_;
};

} // namespace edgeproof::contact
