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

constexpr std::size_t coarse_entries = (1U << coarse_bits) + 1;
constexpr std::size_t fine_entries = (1U << (fine_bits - coarse_bits - 1)) + 2;
constexpr std::size_t finest_entries = (1U << (finest_bits - fine_bits - 1)) + 2;
/// The square of what is left has so many zero bits: |r| <= 2^-17, or 2^-25.
constexpr unsigned tangent_zero_bits = 2 * (fine_bits + 1);
constexpr unsigned finest_zero_bits = 2 * (finest_bits + 1);
/// What arc tangents with one number of bits after the point share.
class ArcTangents {
public:
    explicit ArcTangents(mpfr_prec_t bits)
        : bits_(static_cast<mp_bitcnt_t>(bits)), finest_is_used_(bits >= fixed_point::finest_from),
          series_(fixed_point::WordSeries::odd(bits_, tangent_zero_bits, true)),
          finest_series_(fixed_point::WordSeries::odd(bits_, finest_zero_bits, true)) {}
    /// result = atan t, 2^-17 <= t <= 1.
    void of(mpfr_ptr result, mpfr_srcptr t) {
        mpfr_mul_2ui(result, t, bits_, MPFR_RNDN);
        mpfr_get_z(r_.get(), result, MPFR_RNDN);
        const long i = reduce(coarse_bits);
        const long j = reduce(fine_bits);
        const long k = finest_is_used_ ? reduce(finest_bits) : 0;
        series_of(r_, finest_is_used_ ? finest_series_ : series_);
        mpz_mul(sum_.get(), sum_.get(), r_.get());
        mpz_fdiv_q_2exp(sum_.get(), sum_.get(), bits_);
        add_entry(coarse_, i, coarse_bits);
        add_entry(fine_, j, fine_bits);
        add_entry(finest_, k, finest_bits);
        mpfr_set_z_2exp(result, sum_.get(), -static_cast<mpfr_exp_t>(bits_), MPFR_RNDN);
    }
    /// result = atan t, |t| < 2^-17, with the relative error that a product has.
    void of_small(mpfr_ptr result, mpfr_srcptr t) {
        mpfr_mul_2ui(result, t, bits_, MPFR_RNDN);
        mpfr_get_z(r_.get(), result, MPFR_RNDN);
        series_of(r_, series_);
        mpfr_set_z_2exp(result, sum_.get(), -static_cast<mpfr_exp_t>(bits_), MPFR_RNDN);
        mpfr_mul(result, result, t, MPFR_RNDN);
    }

private:
    /// r <- (r - q)/(1 + r q) for the q = i/2^k next to it; i.
    long reduce(unsigned k) {
        mpz_fdiv_q_2exp(work_.get(), r_.get(), bits_ - k - 1);
        const long twice = mpz_get_si(work_.get());
        const long i = (twice + 1) >> 1;
        if (i == 0) {
            return 0;
        }
        mpz_mul_si(below_.get(), r_.get(), i);
        mpz_set_ui(work_.get(), 1);
        mpz_mul_2exp(work_.get(), work_.get(), bits_ + k);
        mpz_add(below_.get(), below_.get(), work_.get());
        mpz_mul_2exp(r_.get(), r_.get(), k);
        mpz_set_si(work_.get(), i);
        mpz_mul_2exp(work_.get(), work_.get(), bits_);
        mpz_sub(r_.get(), r_.get(), work_.get());
        mpz_mul_2exp(r_.get(), r_.get(), bits_);
        mpz_fdiv_q(r_.get(), r_.get(), below_.get());
        return i;
    }
    /// sum <- atan(r)/r = 1 - r^2/3 + r^4/5 - ...
    void series_of(GmpInteger& r, fixed_point::WordSeries& series) {
        mpz_mul(square_.get(), r.get(), r.get());
        mpz_fdiv_q_2exp(square_.get(), square_.get(), bits_);
        series.sum(sum_, square_);
    }
    /// sum <- sum + atan(i/2^k).
    template <std::size_t N> void add_entry(std::array<GmpInteger, N>& table, long i, unsigned k) {
        if (i < 0) {
            mpz_sub(sum_.get(), sum_.get(), entry(table, -i, k));
        } else {
            mpz_add(sum_.get(), sum_.get(), entry(table, i, k));
        }
    }
    /// atan(i/2^k), MPFR's.
    template <std::size_t N>
    mpz_srcptr entry(std::array<GmpInteger, N>& table, long i, unsigned k) {
        GmpInteger& known = table[static_cast<std::size_t>(i)];
        if (i != 0 && mpz_sgn(known.get()) == 0) {
            const auto precision = static_cast<mpfr_prec_t>(bits_);
            mpfr_t value;
            mpfr_init2(value, precision);
            mpfr_set_si_2exp(value, i, -static_cast<mpfr_exp_t>(k), MPFR_RNDN);
            mpfr_atan(value, value, MPFR_RNDN);
            mpfr_mul_2ui(value, value, bits_, MPFR_RNDN);
            mpfr_get_z(known.get(), value, MPFR_RNDN);
            mpfr_clear(value);
        }
        return known.get();
    }

    mp_bitcnt_t bits_;
    bool finest_is_used_;
    std::array<GmpInteger, coarse_entries> coarse_;
    std::array<GmpInteger, fine_entries> fine_;
    std::array<GmpInteger, finest_entries> finest_;
    fixed_point::WordSeries series_;
    fixed_point::WordSeries finest_series_;
    GmpInteger r_;
    GmpInteger sum_;
    GmpInteger square_;
    GmpInteger below_;
    GmpInteger work_;
};

} // namespace

Real arc_tangent(const Real& x) {
    Real result = fixed_point::beside(x);
    mpfr_srcptr from = x.backend().data();
    const mpfr_prec_t asked = mpfr_get_prec(result.backend().data());
    if (mpfr_regular_p(from) == 0 || asked > fixed_point::most_bits ||
        std::abs(mpfr_get_exp(from)) > asked) {
        mpfr_atan(result.backend().data(), from, MPFR_RNDN);
        return result;
    }
    const mpfr_prec_t bits = fixed_point::bits_for(asked);
    auto& table = fixed_point::table_of<ArcTangents>(bits);
    mpfr_t t;
    mpfr_init2(t, bits);
    mpfr_abs(t, from, MPFR_RNDN);
    const bool inverted = mpfr_cmp_ui(t, 1) > 0;
    if (inverted) {
        mpfr_ui_div(t, 1, t, MPFR_RNDN);
    }
    mpfr_t angle;
    mpfr_init2(angle, bits);
    if (mpfr_get_exp(t) >= -static_cast<mpfr_exp_t>(fine_bits)) {
        table.of(angle, t);
    } else {
        table.of_small(angle, t);
    }
    if (inverted) {
        mpfr_const_pi(t, MPFR_RNDN);
        mpfr_div_2ui(t, t, 1, MPFR_RNDN);
        mpfr_sub(angle, t, angle, MPFR_RNDN);
    }
    mpfr_setsign(result.backend().data(), angle, mpfr_signbit(from), MPFR_RNDN);
    mpfr_clear(angle);
    mpfr_clear(t);
    return result;
}

} // namespace edgeproof
