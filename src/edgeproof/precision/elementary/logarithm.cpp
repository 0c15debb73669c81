// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/precision/elementary/elementary.hpp"
#include "edgeproof/precision/elementary/fixed_point.hpp"

#include <array>
#include <cstdlib>

namespace edgeproof {
namespace {

using fixed_point::coarse_bits;
using fixed_point::fine_bits;
using fixed_point::finest_bits;
using fixed_point::GmpInteger;

/// v = 2^e m with 3/4 <= m < 3/2.
constexpr long coarse_first = 3L << (coarse_bits - 2);
constexpr long coarse_last = 3L << (coarse_bits - 1);
/// m over the nearest i/2^8 is 1 to within 2^-9/(3/4).
constexpr long fine_centre = 1L << fine_bits;
constexpr long fine_reach = (1L << (fine_bits - coarse_bits)) * 2 / 3 + 2;
constexpr long finest_centre = 1L << finest_bits;
constexpr long finest_reach = (1L << (finest_bits - fine_bits - 1)) + 4;
/// The square of what is left has so many zero bits: |y| <= 2^-18, or 2^-26.
constexpr unsigned quotient_zero_bits = 2 * (fine_bits + 2);
constexpr unsigned finest_quotient_zero_bits = 2 * (finest_bits + 2);
/// An argument below this stands for itself: 1 + x would lose its digits.
constexpr mpfr_exp_t small_exponent = -17;

/// What logarithms with one number of bits after the point share.
class Logarithms {
public:
    explicit Logarithms(mpfr_prec_t bits)
        : bits_(static_cast<mp_bitcnt_t>(bits)), finest_is_used_(bits >= fixed_point::finest_from),
          series_(fixed_point::WordSeries::odd(bits_, quotient_zero_bits, false)),
          finest_series_(fixed_point::WordSeries::odd(bits_, finest_quotient_zero_bits, false)) {}
    /// result = ln v, v > 1.
    void of(mpfr_ptr result, mpfr_srcptr v) {
        // v/2^e as a fixed-point number.
        mpfr_exp_t e = mpfr_get_exp(v) - 1;
        mpfr_mul_2si(result, v, static_cast<long>(bits_) - e, MPFR_RNDN);
        mpfr_get_z(r_.get(), result, MPFR_RNDN);
        mpz_fdiv_q_2exp(work_.get(), r_.get(), bits_ - 1);
        if (mpz_cmp_ui(work_.get(), 3) >= 0) { // 3/2 and more
            ++e;
            mpz_fdiv_q_2exp(r_.get(), r_.get(), 1);
        }
        const long i = divide(coarse_bits);
        const long j = finest_is_used_ ? divide(fine_bits) : nearest(fine_bits);
        const long k = finest_is_used_ ? nearest(finest_bits) : j;
        // y = (r - c)/(r + c), c = k/2^24 or j/2^16.
        mpz_set_si(work_.get(), k);
        mpz_mul_2exp(work_.get(), work_.get(), bits_ - (finest_is_used_ ? finest_bits : fine_bits));
        mpz_add(below_.get(), r_.get(), work_.get());
        mpz_sub(r_.get(), r_.get(), work_.get());
        mpz_mul_2exp(r_.get(), r_.get(), bits_);
        mpz_fdiv_q(r_.get(), r_.get(), below_.get());
        series_of(r_, finest_is_used_ ? finest_series_ : series_);
        mpz_mul(sum_.get(), sum_.get(), r_.get());
        mpz_fdiv_q_2exp(sum_.get(), sum_.get(), bits_ - 1);
        mpz_add(sum_.get(), sum_.get(), entry(coarse_, i - coarse_first, i, coarse_bits));
        mpz_add(sum_.get(), sum_.get(), entry(fine_, j - fine_centre + fine_reach, j, fine_bits));
        if (finest_is_used_) {
            mpz_add(sum_.get(), sum_.get(),
                    entry(finest_, k - finest_centre + finest_reach, k, finest_bits));
        }
        if (e != 0) {
            mpz_addmul_ui(sum_.get(), entry(two_, 0, 2, 0), static_cast<unsigned long>(e));
        }
        mpfr_set_z_2exp(result, sum_.get(), -static_cast<mpfr_exp_t>(bits_), MPFR_RNDN);
    }
    /// result = ln (1 + x), 0 < x < 2^-17, with the relative error that a product has.
    void of_one_and_small(mpfr_ptr result, mpfr_srcptr x) {
        mpfr_t y;
        mpfr_init2(y, static_cast<mpfr_prec_t>(bits_));
        mpfr_add_ui(y, x, 2, MPFR_RNDN);
        mpfr_div(y, x, y, MPFR_RNDN);
        mpfr_mul_2ui(result, y, bits_, MPFR_RNDN);
        mpfr_get_z(r_.get(), result, MPFR_RNDN);
        series_of(r_, series_);
        mpfr_set_z_2exp(result, sum_.get(), 1 - static_cast<mpfr_exp_t>(bits_), MPFR_RNDN);
        mpfr_mul(result, result, y, MPFR_RNDN);
        mpfr_clear(y);
    }

private:
    /// The integer nearest to r 2^k.
    long nearest(unsigned k) {
        mpz_fdiv_q_2exp(work_.get(), r_.get(), bits_ - k - 1);
        return (mpz_get_si(work_.get()) + 1) >> 1;
    }
    /// r <- r/(n/2^k) for the n/2^k next to it; n.
    long divide(unsigned k) {
        const long n = nearest(k);
        mpz_mul_2exp(r_.get(), r_.get(), k);
        mpz_fdiv_q_ui(r_.get(), r_.get(), static_cast<unsigned long>(n));
        return n;
    }
    /// sum <- artanh(y)/y = 1 + y^2/3 + y^4/5 + ...
    void series_of(GmpInteger& y, fixed_point::WordSeries& series) {
        mpz_mul(square_.get(), y.get(), y.get());
        mpz_fdiv_q_2exp(square_.get(), square_.get(), bits_);
        series.sum(sum_, square_);
    }
    /// ln(n/2^k), MPFR's, kept at `place`.
    template <std::size_t N>
    mpz_srcptr entry(std::array<GmpInteger, N>& table, long place, long n, unsigned k) {
        GmpInteger& known = table[static_cast<std::size_t>(place)];
        if (n != 1L << k && mpz_sgn(known.get()) == 0) {
            mpfr_t value;
            mpfr_init2(value, static_cast<mpfr_prec_t>(bits_));
            mpfr_set_si_2exp(value, n, -static_cast<mpfr_exp_t>(k), MPFR_RNDN);
            mpfr_log(value, value, MPFR_RNDN);
            mpfr_mul_2ui(value, value, bits_, MPFR_RNDN);
            mpfr_get_z(known.get(), value, MPFR_RNDN);
            mpfr_clear(value);
        }
        return known.get();
    }

    mp_bitcnt_t bits_;
    bool finest_is_used_;
    std::array<GmpInteger, coarse_last - coarse_first + 1> coarse_;
    std::array<GmpInteger, 2 * fine_reach + 1> fine_;
    std::array<GmpInteger, 2 * finest_reach + 1> finest_;
    std::array<GmpInteger, 1> two_;
    fixed_point::WordSeries series_;
    fixed_point::WordSeries finest_series_;
    GmpInteger r_;
    GmpInteger sum_;
    GmpInteger square_;
    GmpInteger below_;
    GmpInteger work_;
};

} // namespace

Real log_of_one_plus(const Real& x) {
    Real result = fixed_point::beside(x);
    mpfr_srcptr from = x.backend().data();
    const mpfr_prec_t asked = mpfr_get_prec(result.backend().data());
    if (mpfr_regular_p(from) == 0 || mpfr_signbit(from) != 0 || asked > fixed_point::most_bits ||
        std::abs(mpfr_get_exp(from)) > asked) {
        mpfr_log1p(result.backend().data(), from, MPFR_RNDN);
        return result;
    }
    const mpfr_prec_t bits = fixed_point::bits_for(asked);
    auto& table = fixed_point::table_of<Logarithms>(bits);
    mpfr_t t;
    mpfr_init2(t, bits);
    if (mpfr_get_exp(from) <= small_exponent) {
        mpfr_t y;
        mpfr_init2(y, bits);
        mpfr_set(y, from, MPFR_RNDN);
        table.of_one_and_small(t, y);
        mpfr_clear(y);
    } else {
        mpfr_t v;
        mpfr_init2(v, bits);
        mpfr_add_ui(v, from, 1, MPFR_RNDN);
        table.of(t, v);
        mpfr_clear(v);
    }
    mpfr_set(result.backend().data(), t, MPFR_RNDN);
    mpfr_clear(t);
    return result;
}

} // namespace edgeproof
