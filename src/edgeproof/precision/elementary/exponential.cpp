// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/precision/elementary/elementary.hpp"
#include "edgeproof/precision/elementary/fixed_point.hpp"

#include <array>

namespace edgeproof {
namespace {

using fixed_point::GmpInteger;

constexpr unsigned exp_step_bits = 8; ///< of each table's arguments
constexpr std::size_t exp_entries = 1U << exp_step_bits;
constexpr std::size_t exp_tables = 3;
/// What is left over: |r| < 2^-24.
constexpr unsigned exp_zero_bits = exp_step_bits * exp_tables;
/// Bits of ln 2 beyond those of the result: as many as a multiple of it may take.
constexpr mp_bitcnt_t ln_2_bits = 32;
/// |x| < 2^this.
constexpr mpfr_exp_t largest_exponent = 20;
/// The units that a product of table entries adds up, and what e^x - 1 loses for |x| >= 2^-25.
constexpr mpfr_prec_t more_bits = 40;

/// What exponentials with one number of bits after the point share.
class Exponentials {
public:
    explicit Exponentials(mpfr_prec_t bits)
        : bits_(static_cast<mp_bitcnt_t>(bits)),
          series_(fixed_point::WordSeries::factorial(bits_, exp_zero_bits, 1, false)),
          rising_(fixed_point::WordSeries::factorial(bits_, exp_zero_bits, 2, false)),
          falling_(fixed_point::WordSeries::factorial(bits_, exp_zero_bits, 2, true)) {
        mpfr_t value;
        mpfr_init2(value, static_cast<mpfr_prec_t>(bits_ + ln_2_bits));
        mpfr_const_log2(value, MPFR_RNDN);
        mpfr_mul_2ui(value, value, bits_ + ln_2_bits, MPFR_RNDN);
        mpfr_get_z(ln_2_.get(), value, MPFR_RNDN);
        for (unsigned t = 0; t < exp_tables; ++t) {
            mpz_setbit(tables_[t][0].get(), bits_);
            mpfr_set_ui_2exp(value, 1, -static_cast<mpfr_exp_t>((t + 1) * exp_step_bits),
                             MPFR_RNDN);
            mpfr_exp(value, value, MPFR_RNDN);
            mpfr_mul_2ui(value, value, bits_, MPFR_RNDN);
            mpfr_get_z(tables_[t][1].get(), value, MPFR_RNDN);
            for (std::size_t i = 2; i < exp_entries; ++i) {
                times(tables_[t][i], tables_[t][i / 2], tables_[t][i - i / 2]);
            }
        }
        mpfr_clear(value);
    }
    /// result = e^x, |x| < 2^20.
    void of(mpfr_ptr result, mpfr_srcptr x) {
        // x = k ln 2 + r, 0 <= r < ln 2.
        mpfr_mul_2ui(result, x, bits_ + ln_2_bits, MPFR_RNDD);
        mpfr_get_z(r_.get(), result, MPFR_RNDD);
        mpz_fdiv_qr(work_.get(), r_.get(), r_.get(), ln_2_.get());
        const long k = mpz_get_si(work_.get());
        mpz_fdiv_q_2exp(r_.get(), r_.get(), ln_2_bits);
        std::array<unsigned long, exp_tables> at{};
        for (unsigned t = 0; t < exp_tables; ++t) {
            const mp_bitcnt_t below = bits_ - mp_bitcnt_t{t + 1} * exp_step_bits;
            mpz_fdiv_q_2exp(work_.get(), r_.get(), below);
            at[t] = mpz_get_ui(work_.get());
            mpz_fdiv_r_2exp(r_.get(), r_.get(), below);
        }
        series_.sum(sum_, r_);
        for (unsigned t = 0; t < exp_tables; ++t) {
            if (at[t] != 0) {
                times(sum_, sum_, tables_[t][at[t]]);
            }
        }
        mpfr_set_z_2exp(result, sum_.get(), k - static_cast<mpfr_exp_t>(bits_), MPFR_RNDN);
    }
    /// result = e^x - 1, |x| < 2^-24, with the relative error that a product has.
    void less_one_of_small(mpfr_ptr result, mpfr_srcptr x) {
        mpfr_mul_2ui(result, x, bits_, MPFR_RNDZ);
        mpfr_get_z(r_.get(), result, MPFR_RNDZ);
        const bool negative = mpz_sgn(r_.get()) < 0;
        mpz_abs(r_.get(), r_.get());
        (negative ? falling_ : rising_).sum(sum_, r_);
        mpfr_set_z_2exp(result, sum_.get(), -static_cast<mpfr_exp_t>(bits_), MPFR_RNDN);
        mpfr_mul(result, result, x, MPFR_RNDN);
    }

private:
    void times(GmpInteger& product, const GmpInteger& x, const GmpInteger& y) {
        mpz_mul(work_.get(), x.get(), y.get());
        mpz_fdiv_q_2exp(product.get(), work_.get(), bits_);
    }

    mp_bitcnt_t bits_;
    std::array<std::array<GmpInteger, exp_entries>, exp_tables> tables_;
    fixed_point::WordSeries series_;
    fixed_point::WordSeries rising_;
    fixed_point::WordSeries falling_;
    GmpInteger ln_2_;
    GmpInteger r_;
    GmpInteger sum_;
    GmpInteger work_;
};

} // namespace

Real exp_less_one(const Real& x) {
    Real result = fixed_point::beside(x);
    mpfr_srcptr from = x.backend().data();
    const mpfr_prec_t asked = mpfr_get_prec(result.backend().data());
    if (mpfr_regular_p(from) == 0 || asked > fixed_point::most_bits ||
        mpfr_get_exp(from) > largest_exponent || mpfr_get_exp(from) < -asked) {
        mpfr_expm1(result.backend().data(), from, MPFR_RNDN);
        return result;
    }
    const mpfr_prec_t bits = fixed_point::bits_for(asked + more_bits);
    auto& table = fixed_point::table_of<Exponentials>(bits);
    mpfr_t t;
    mpfr_init2(t, bits + static_cast<mpfr_prec_t>(ln_2_bits) + largest_exponent);
    if (mpfr_get_exp(from) <= -static_cast<mpfr_exp_t>(exp_zero_bits)) {
        table.less_one_of_small(t, from);
    } else {
        table.of(t, from);
        mpfr_sub_ui(t, t, 1, MPFR_RNDN);
    }
    mpfr_set(result.backend().data(), t, MPFR_RNDN);
    mpfr_clear(t);
    return result;
}

} // namespace edgeproof
