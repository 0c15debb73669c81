// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/real.hpp"

#include <cstddef>
#include <map>
#include <vector>

/// What the elementary functions of elementary.hpp and the series of ratio_series.hpp are made of.
/// Of use to them alone.
namespace edgeproof::fixed_point {

/// An integer of GMP's; as a fixed-point number it counts units of 2^-bits.
class GmpInteger {
public:
    GmpInteger() { mpz_init(z_); }
    GmpInteger(const GmpInteger&) = delete;
    GmpInteger& operator=(const GmpInteger&) = delete;
    GmpInteger(GmpInteger&& other) noexcept {
        mpz_init(z_);
        mpz_swap(z_, other.z_);
    }
    ~GmpInteger() { mpz_clear(z_); }
    [[nodiscard]] mpz_ptr get() { return z_; }
    [[nodiscard]] mpz_srcptr get() const { return z_; }

private:
    mpz_t z_;
};

/// A non-negative number without its last limbs, which are not copied: to be used at once.
class Upper {
public:
    Upper(const GmpInteger& x, mp_size_t limbs) {
        const auto size = static_cast<mp_size_t>(mpz_size(x.get()));
        const bool any = size > limbs;
        mpz_roinit_n(z_, mpz_limbs_read(x.get()) + (any ? limbs : 0), any ? size - limbs : 0);
    }
    [[nodiscard]] mpz_srcptr get() const { return z_; }

private:
    mpz_t z_;
};

/// Above, the tables are not worth their size.
constexpr mpfr_prec_t most_bits = 12000;
/// Bits beyond those asked for: 18 for a result as small as 2^-18, the others for the roundoff of
/// some twenty truncated operations with room to spare.
constexpr mpfr_prec_t guard_bits = 40;
/// The arguments that a table holds: steps of 2^-8, within one of these of 2^-16, and where a
/// division costs less than the terms that it saves, within one of those of 2^-24.
constexpr unsigned coarse_bits = 8;
constexpr unsigned fine_bits = 16;
constexpr unsigned finest_bits = 24;
constexpr mpfr_prec_t finest_from = 800;
/// Thread-local tables of more precisions than this are made anew.
constexpr std::size_t most_tables = 48;

/// Bits after the point for a result of so many: whole limbs, so that few precisions have a table.
[[nodiscard]] constexpr mpfr_prec_t bits_for(mpfr_prec_t asked) {
    return (asked + guard_bits + 63) / 64 * 64;
}

/// What the functions with one number of bits after the point share; a thread has its own.
template <class Table> [[nodiscard]] Table& table_of(mpfr_prec_t bits) {
    thread_local std::map<mpfr_prec_t, Table> tables;
    if (tables.size() > most_tables) {
        tables.clear();
    }
    return tables.try_emplace(bits, bits).first->second;
}

/// The sum over k of (-+1)^k c_k s^k, of fixed-point numbers with one number of bits after the
/// point, for coefficients that are quotients of words: what the functions have in common.
class WordSeries {
public:
    /// c_k = 1/(2k + 1), for 0 <= s < 2^-zero_bits.
    [[nodiscard]] static WordSeries odd(mp_bitcnt_t bits, unsigned zero_bits, bool alternating);
    /// c_k = 1/(first (first + 1) ... (first + k - 1)): 1/k! from 1, 1/(k + 1)! from 2.
    [[nodiscard]] static WordSeries factorial(mp_bitcnt_t bits, unsigned zero_bits, unsigned first,
                                              bool alternating);
    /// sum <- the sum, to a few units of 2^-bits.
    void sum(GmpInteger& sum, const GmpInteger& s);

private:
    /// Terms over one denominator, the product of theirs: no more of them than a word can hold.
    struct Block {
        unsigned long denominator = 1;
        std::vector<unsigned long> numerators;
    };
    WordSeries(mp_bitcnt_t bits, unsigned zero_bits, bool alternating, std::size_t largest);
    [[nodiscard]] mp_size_t unneeded(std::size_t k) const;

    mp_bitcnt_t bits_;
    unsigned zero_bits_;
    bool alternating_;
    bool chained_ = false;   ///< a block's denominator divides all that follows, too
    std::size_t last_;       ///< term
    std::size_t length_ = 2; ///< of a block; even
    std::vector<Block> blocks_;
    std::vector<GmpInteger> powers_; ///< 1, s, ..., s^length
    GmpInteger product_;
    GmpInteger block_;
};

/// A `Real` for a function of x: of the thread's precision, or of x's own where that is higher.
[[nodiscard]] inline Real beside(const Real& x) {
    Real result;
    const mpfr_prec_t own = mpfr_get_prec(x.backend().data());
    if (own > mpfr_get_prec(result.backend().data())) {
        mpfr_set_prec(result.backend().data(), own);
    }
    return result;
}

} // namespace edgeproof::fixed_point
