// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/real.hpp"

#include <algorithm>
#include <cmath>

namespace edgeproof::quadrature {

/// ln |x| in binary64, for any size of x; -1e300 for 0.
[[nodiscard]] inline double ln_size(const Real& x) {
    if (x == 0) {
        return -1e300;
    }
    long exponent = 0;
    const double mantissa = mpfr_get_d_2exp(&exponent, x.backend().data(), MPFR_RNDN);
    return std::log(std::abs(mantissa)) + 0.6931471805599453 * static_cast<double>(exponent);
}

/// exp(ln) to the digits of binary64, for any ln; accurate enough for an estimate.
[[nodiscard]] inline Real from_ln_size(double ln) {
    ln = std::clamp(ln, -1e15, 1e15);
    const double exponent = std::floor(ln / 0.6931471805599453);
    Real x;
    mpfr_set_d(x.backend().data(), std::exp(ln - 0.6931471805599453 * exponent), MPFR_RNDN);
    mpfr_mul_2si(x.backend().data(), x.backend().data(), static_cast<long>(exponent), MPFR_RNDN);
    return x;
}

/// The estimated distance of the last level of a sequence from the integral, from the last two
/// differences (`bailey-jeyabalan-li2005`): for a rule that converges quadratically the digits grow
/// as d_1^2/d_2, that is, they double. A growth by at most the factor 1.4 is assumed, since an
/// integrand with two scales converges more slowly at first. This is an estimate.
class LevelEstimate {
public:
    /// Takes the next level; returns ln of its estimated absolute error.
    double next(const Real& value) {
        const double size = ln_size(value);
        double error = 1e300;
        if (count_ > 0) {
            const double d1 = ln_size(Real(value - last_)) - size;
            error = d1;
            if (count_ > 1) {
                const double d2 = ln_size(Real(value - before_)) - size;
                if (d1 < d2 && d2 < -2) {
                    error = d1 * growth(d1, d2);
                }
            }
            difference_ = d1 + size;
            error += size;
        }
        before_ = last_;
        last_ = value;
        ++count_;
        return error;
    }
    /// The assumed ratio of the digits of a level to those that it shares with the level before.
    /// exp(d1) is the relative difference of these two levels, exp(d2) that of the two levels
    /// before; d1 < d2 < 0.
    [[nodiscard]] static double growth(double d1, double d2) { return std::min(d1 / d2, 1.4); }

    /// ln of the last absolute difference.
    [[nodiscard]] double difference() const { return difference_; }

private:
    Real last_;
    Real before_;
    int count_ = 0;
    double difference_ = 1e300;
};

} // namespace edgeproof::quadrature
