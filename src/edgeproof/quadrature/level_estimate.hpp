// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/real.hpp"

#include <algorithm>
#include <cmath>

namespace edgeproof::quadrature {

/// ln |x|, in binary64 whatever the size of x; -1e300 for 0.
[[nodiscard]] inline double ln_size(const Real& x) {
    if (x == 0) {
        return -1e300;
    }
    long exponent = 0;
    const double mantissa = mpfr_get_d_2exp(&exponent, x.backend().data(), MPFR_RNDN);
    return std::log(std::abs(mantissa)) + 0.6931471805599453 * static_cast<double>(exponent);
}

/// exp(ln), to the digits of binary64, for any ln: what an estimate needs and no more.
[[nodiscard]] inline Real from_ln_size(double ln) {
    ln = std::clamp(ln, -1e15, 1e15);
    const double exponent = std::floor(ln / 0.6931471805599453);
    Real x;
    mpfr_set_d(x.backend().data(), std::exp(ln - 0.6931471805599453 * exponent), MPFR_RNDN);
    mpfr_mul_2si(x.backend().data(), x.backend().data(), static_cast<long>(exponent), MPFR_RNDN);
    return x;
}

/// How far the last of a sequence of levels is from the integral, from the last two differences:
/// the digits of a rule that converges quadratically grow as d_1^2/d_2 (D. H. Bailey, K. Jeyabalan,
/// X. S. Li, Experimental Mathematics 14 (2005) 317). They double in theory; no more than 1.4 times
/// as many are counted on, since an integrand with two scales is slower at first. An estimate.
class LevelEstimate {
public:
    /// Takes the next level; returns ln of the estimated error, absolute.
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
    /// How many times its digits a level is counted on to have when it differs from the one before
    /// by exp(d1), which differed by exp(d2) from its own; d1 < d2 < 0.
    [[nodiscard]] static double growth(double d1, double d2) { return std::min(d1 / d2, 1.4); }

    /// ln of the last difference.
    [[nodiscard]] double difference() const { return difference_; }

private:
    Real last_;
    Real before_;
    int count_ = 0;
    double difference_ = 1e300;
};

} // namespace edgeproof::quadrature
