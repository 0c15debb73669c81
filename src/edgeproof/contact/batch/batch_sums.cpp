// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/batch/batch_sums.hpp"

#include "edgeproof/precision/ball/ball.hpp"

#include <bit>
#include <cmath>

namespace edgeproof::contact {
namespace {

/// For larger numerators or denominators logarithms cost less.
constexpr long largest_by_root = 4096;

} // namespace

RealPower::RealPower(const Exact& exponent) : exponent_(exponent.to<Real>()) {
    if (!exponent.is_rational()) {
        return;
    }
    const Integer p = numerator(exponent.rational());
    const Integer q = denominator(exponent.rational());
    if (abs(p) > largest_by_root || q > largest_by_root) {
        return;
    }
    by_root_ = true;
    numerator_ = p.convert_to<long>();
    denominator_ = q.convert_to<unsigned long>();
    // Newton's rule (DLMF 3.8.4) for the inverse root is y <- y + y (1 - x y^q)/q. Precisions are
    // listed from the last step to the first one: each step doubles the number of bits, minus a
    // loss that grows with the exponent.
    const auto lost = static_cast<long>(std::bit_width(denominator_)) + 3;
    std::vector<long> precisions;
    for (long bits = mpfr_get_prec(raw(exponent_)); bits > 46 - lost / 2; bits = bits / 2 + lost) {
        precisions.push_back(bits);
        if (bits / 2 + lost >= bits) {
            break;
        }
    }
    for (std::size_t k = precisions.size(); k-- > 0;) {
        Step step;
        mpfr_set_prec(raw(step.x), precisions[k]);
        mpfr_set_prec(raw(step.y), precisions[k]);
        mpfr_set_prec(raw(step.product), precisions[k]);
        steps_.push_back(std::move(step));
    }
}

void RealPower::raise(Real& out, const Real& y, unsigned long n) {
    if (n == 1) {
        mpfr_set(raw(out), raw(y), MPFR_RNDN);
        return;
    }
    const int top = static_cast<int>(std::bit_width(n)) - 1;
    mpfr_sqr(raw(out), raw(y), MPFR_RNDN);
    for (int bit = top - 1; bit >= 0; --bit) {
        if (((n >> static_cast<unsigned>(bit)) & 1U) != 0) {
            mpfr_mul(raw(out), raw(out), raw(y), MPFR_RNDN);
        }
        if (bit > 0) {
            mpfr_sqr(raw(out), raw(out), MPFR_RNDN);
        }
    }
}

void RealPower::operator()(Real& out, const Real& x) {
    if (by_root_ && numerator_ == 0) {
        mpfr_set_ui(raw(out), 1, MPFR_RNDN);
        return;
    }
    if (by_root_ && denominator_ == 1) {
        mpfr_pow_si(raw(out), raw(x), numerator_, MPFR_RNDN);
        return;
    }
    const double start = mpfr_get_d(raw(x), MPFR_RNDN);
    if (!by_root_ || !(start > 1e-290 && start < 1e290)) {
        const long bits = mpfr_get_prec(raw(exponent_)) + 8;
        // The absolute error of the logarithm of a very large or small number needs more bits.
        const auto exponent = static_cast<unsigned long>(std::abs(mpfr_get_exp(raw(x))));
        const auto far = static_cast<long>(std::bit_width(exponent));
        Ball power = Ball(x, bits + far);
        power = exp(Ball(exponent_, bits + far) * log(power));
        arf_get_mpfr(raw(out), arb_midref(power.data()), MPFR_RNDN);
        return;
    }
    // Newton's iteration for f(y) = y^(-q) - x = 0, y - f/f' = y + y (1 - x y^q)/q.
    const auto q = static_cast<double>(denominator_);
    mpfr_set_d(raw(square_), std::pow(start, -1 / q), MPFR_RNDN);
    const Real* y = &square_;
    for (Step& step : steps_) {
        mpfr_set(raw(step.x), raw(x), MPFR_RNDN);
        mpfr_set(raw(step.y), raw(*y), MPFR_RNDN);
        raise(step.product, step.y, denominator_);
        mpfr_mul(raw(step.product), raw(step.product), raw(step.x), MPFR_RNDN);
        mpfr_ui_sub(raw(step.product), 1, raw(step.product), MPFR_RNDN);
        mpfr_mul(raw(step.product), raw(step.product), raw(step.y), MPFR_RNDN);
        mpfr_div_ui(raw(step.product), raw(step.product), denominator_, MPFR_RNDN);
        mpfr_add(raw(step.y), raw(step.y), raw(step.product), MPFR_RNDN);
        y = &step.y;
    }
    if (numerator_ < 0) {
        raise(out, *y, static_cast<unsigned long>(-numerator_));
        return;
    }
    // x^(i + r/q) = x^(i + 1) y^(q - r).
    const auto n = static_cast<unsigned long>(numerator_);
    raise(root_power_, *y, denominator_ - n % denominator_);
    raise(out, x, n / denominator_ + 1);
    mpfr_mul(raw(out), raw(out), raw(root_power_), MPFR_RNDN);
}

} // namespace edgeproof::contact
