// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/precision/elementary.hpp"
#include "edgeproof/precision/fixed_point.hpp"

#include <array>
#include <cstdlib>
#include <vector>

namespace edgeproof {
namespace {

using fixed_point::coarse_bits;
using fixed_point::fine_bits;
using fixed_point::GmpInteger;

/// v = 2^e m with 3/4 <= m < 3/2.
constexpr long coarse_first = 3L << (coarse_bits - 2);
constexpr long coarse_last = 3L << (coarse_bits - 1);
/// m over the nearest i/2^8 is 1 to within 2^-9/(3/4).
constexpr long fine_centre = 1L << fine_bits;
constexpr long fine_reach = (1L << (fine_bits - coarse_bits)) * 2 / 3 + 2;
/// The square of what is left has so many zero bits: |y| <= 2^-18.
constexpr unsigned quotient_zero_bits = 2 * (fine_bits + 2);
/// An argument below this stands for itself: 1 + x would lose its digits.
constexpr mpfr_exp_t small_exponent = -17;

/// What logarithms with one number of bits after the point share.
class Logarithms {
public:
    explicit Logarithms(mpfr_prec_t bits) : bits_(static_cast<mp_bitcnt_t>(bits)) {
        for (mp_bitcnt_t k = 0; k <= bits_ / quotient_zero_bits + 1; ++k) {
            reciprocals_.emplace_back();
            mpz_setbit(reciprocals_.back().get(), bits_);
            mpz_fdiv_q_ui(reciprocals_.back().get(), reciprocals_.back().get(), 2 * k + 1);
        }
    }
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
        const long i = nearest(coarse_bits);
        mpz_mul_2exp(r_.get(), r_.get(), coarse_bits);
        mpz_fdiv_q_ui(r_.get(), r_.get(), static_cast<unsigned long>(i));
        const long j = nearest(fine_bits);
        // y = (r - c)/(r + c), c = j/2^16.
        mpz_set_si(work_.get(), j);
        mpz_mul_2exp(work_.get(), work_.get(), bits_ - fine_bits);
        mpz_add(below_.get(), r_.get(), work_.get());
        mpz_sub(r_.get(), r_.get(), work_.get());
        mpz_mul_2exp(r_.get(), r_.get(), bits_);
        mpz_fdiv_q(r_.get(), r_.get(), below_.get());
        series_of(r_);
        mpz_mul(sum_.get(), sum_.get(), r_.get());
        mpz_fdiv_q_2exp(sum_.get(), sum_.get(), bits_ - 1);
        mpz_add(sum_.get(), sum_.get(), entry(coarse_, i - coarse_first, i, coarse_bits));
        mpz_add(sum_.get(), sum_.get(), entry(fine_, j - fine_centre + fine_reach, j, fine_bits));
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
        series_of(r_);
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
    /// sum <- artanh(y)/y = 1 + y^2/3 + y^4/5 + ...
    void series_of(GmpInteger& y) {
        mpz_mul(square_.get(), y.get(), y.get());
        mpz_fdiv_q_2exp(square_.get(), square_.get(), bits_);
        std::size_t k = reciprocals_.size() - 1;
        mpz_set(sum_.get(), reciprocals_[k].get());
        while (k-- > 0) {
            mpz_mul(work_.get(), sum_.get(), square_.get());
            mpz_fdiv_q_2exp(work_.get(), work_.get(), bits_);
            mpz_add(sum_.get(), reciprocals_[k].get(), work_.get());
        }
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
    std::array<GmpInteger, coarse_last - coarse_first + 1> coarse_;
    std::array<GmpInteger, 2 * fine_reach + 1> fine_;
    std::array<GmpInteger, 1> two_;
    std::vector<GmpInteger> reciprocals_; ///< 1/(2k + 1)
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
