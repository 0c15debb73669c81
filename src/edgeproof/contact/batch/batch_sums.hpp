// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/profile/edge.hpp"
#include "edgeproof/precision/ball/ball.hpp"
#include "edgeproof/precision/real.hpp"

#include <cstddef>
#include <vector>

namespace edgeproof::contact {

/// The inner loops of the batch routes: sums over nodes by MPFR functions, which create no
/// temporary numbers. One object belongs to one thread and one precision.
class NodeSums {
public:
    /// Adds the sum of numerator/(from + gap) to `sum`.
    void add_quotients(Real& sum, const std::vector<Real>& numerator, const std::vector<Real>& from,
                       const Real& gap) {
        for (std::size_t k = 0; k < from.size(); ++k) {
            mpfr_add(raw(below_), raw(from[k]), raw(gap), MPFR_RNDN);
            mpfr_div(raw(above_), raw(numerator[k]), raw(below_), MPFR_RNDN);
            mpfr_add(raw(sum), raw(sum), raw(above_), MPFR_RNDN);
        }
    }
    /// Adds the sum of (height weight + lift)/(from + gap) to `sum`.
    void add_lifted(Real& sum, const Real& height, const std::vector<Real>& weight,
                    const std::vector<Real>& lift, const std::vector<Real>& from, const Real& gap) {
        for (std::size_t k = 0; k < from.size(); ++k) {
            mpfr_add(raw(below_), raw(from[k]), raw(gap), MPFR_RNDN);
            mpfr_mul(raw(above_), raw(weight[k]), raw(height), MPFR_RNDN);
            mpfr_add(raw(above_), raw(above_), raw(lift[k]), MPFR_RNDN);
            mpfr_div(raw(above_), raw(above_), raw(below_), MPFR_RNDN);
            mpfr_add(raw(sum), raw(sum), raw(above_), MPFR_RNDN);
        }
    }
    /// Adds the sum of weight (rise - height)/(from - gap) to `sum`. At a node so close to the
    /// point that this difference cancels, `fallback(k)` gives the quotient.
    template <class Fallback>
    void add_differences(Real& sum, const std::vector<Real>& weight, const std::vector<Real>& rise,
                         const Real& height, const std::vector<Real>& from, const Real& gap,
                         const Fallback& fallback) {
        constexpr long near_bits = 16;
        for (std::size_t k = 0; k < from.size(); ++k) {
            mpfr_sub(raw(below_), raw(from[k]), raw(gap), MPFR_RNDN);
            if (mpfr_zero_p(raw(below_)) != 0 ||
                mpfr_get_exp(raw(below_)) + near_bits < mpfr_get_exp(raw(from[k]))) {
                sum += weight[k] * fallback(k);
                continue;
            }
            mpfr_sub(raw(above_), raw(rise[k]), raw(height), MPFR_RNDN);
            mpfr_mul(raw(above_), raw(above_), raw(weight[k]), MPFR_RNDN);
            mpfr_div(raw(above_), raw(above_), raw(below_), MPFR_RNDN);
            mpfr_add(raw(sum), raw(sum), raw(above_), MPFR_RNDN);
        }
    }

private:
    Real above_;
    Real below_;
};

/// Computes x^e for one exponent and many x > 0, at the working precision of the thread that
/// created the object, to within some units in the last place. If the exponent is a quotient of
/// small integers, Newton's iteration for the inverse root takes a few products instead of a
/// logarithm and an exponential. Other exponents use Arb.
class RealPower {
public:
    /// `exponent` is e.
    explicit RealPower(const Exact& exponent);

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
