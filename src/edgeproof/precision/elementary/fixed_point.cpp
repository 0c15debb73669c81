// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/precision/elementary/fixed_point.hpp"

#include <algorithm>
#include <limits>

namespace edgeproof::fixed_point {
namespace {

/// How many numbers up to the largest have a product in one word, whichever they are.
std::size_t most_in_a_word(unsigned long largest) {
    unsigned long rest = std::numeric_limits<unsigned long>::max();
    std::size_t count = 0;
    while (rest >= largest) {
        rest /= largest;
        ++count;
    }
    return count;
}

} // namespace

WordSeries::WordSeries(mp_bitcnt_t bits, unsigned zero_bits, bool alternating, std::size_t largest)
    : bits_(bits), zero_bits_(zero_bits), alternating_(alternating), last_(bits / zero_bits + 1) {
    while (length_ * length_ < last_ && length_ + 2 <= most_in_a_word(largest)) {
        length_ += 2;
    }
    powers_.resize(length_ + 1);
    mpz_setbit(powers_[0].get(), bits_);
}

WordSeries WordSeries::odd(mp_bitcnt_t bits, unsigned zero_bits, bool alternating) {
    WordSeries series(bits, zero_bits, alternating, 4 * (bits / zero_bits + 2));
    for (std::size_t k = 0; k <= series.last_; k += series.length_) {
        Block block;
        for (std::size_t j = k; j < k + series.length_; ++j) {
            block.denominator *= 2 * j + 1;
        }
        for (std::size_t j = k; j < k + series.length_; ++j) {
            block.numerators.push_back(block.denominator / (2 * j + 1));
        }
        series.blocks_.push_back(std::move(block));
    }
    return series;
}

WordSeries WordSeries::factorial(mp_bitcnt_t bits, unsigned zero_bits, unsigned first,
                                 bool alternating) {
    WordSeries series(bits, zero_bits, alternating, 2 * (bits / zero_bits + 2) + first);
    series.chained_ = true;
    for (std::size_t k = 0; k <= series.last_; k += series.length_) {
        Block block;
        block.numerators.resize(series.length_);
        for (std::size_t j = series.length_; j-- > 0;) {
            block.denominator *= k + j + first;
            block.numerators[j] = block.denominator;
        }
        series.blocks_.push_back(std::move(block));
    }
    return series;
}

/// Limbs that the factor s^k of a sum leaves without weight. One is kept beyond those that count,
/// so that what is cut off comes to less than 2^-bits in all.
mp_size_t WordSeries::unneeded(std::size_t k) const {
    const auto limbs = static_cast<mp_size_t>(k * zero_bits_ / GMP_NUMB_BITS);
    return std::clamp<mp_size_t>(limbs - 1, 0, static_cast<mp_size_t>(bits_ / GMP_NUMB_BITS));
}

// By blocks, and Horner's rule in s^length from the last, which needs few of the bits.
void WordSeries::sum(GmpInteger& sum, const GmpInteger& s) {
    const auto limbs = static_cast<mp_size_t>(bits_ / GMP_NUMB_BITS);
    mpz_set(powers_[1].get(), s.get());
    for (std::size_t j = 2; j <= length_; ++j) {
        mpz_mul(product_.get(), powers_[j / 2].get(), powers_[j - j / 2].get());
        mpz_set(powers_[j].get(), Upper(product_, limbs).get());
    }
    mpz_set_ui(sum.get(), 0);
    for (std::size_t q = blocks_.size(); q-- > 0;) {
        const std::size_t k = q * length_;
        const mp_size_t cut = unneeded(k);
        const Block& block = blocks_[q];
        mpz_mul_ui(block_.get(), Upper(powers_[0], cut).get(), block.numerators[0]);
        for (std::size_t j = 1; j < length_; ++j) {
            const Upper power(powers_[j], cut);
            if (alternating_ && j % 2 == 1) {
                mpz_submul_ui(block_.get(), power.get(), block.numerators[j]);
            } else {
                mpz_addmul_ui(block_.get(), power.get(), block.numerators[j]);
            }
        }
        mpz_mul(product_.get(), sum.get(), Upper(powers_[length_], cut).get());
        const Upper later(product_, limbs - unneeded(k + length_));
        if (chained_) {
            mpz_add(block_.get(), block_.get(), later.get());
        }
        mpz_fdiv_q_ui(sum.get(), block_.get(), block.denominator);
        if (!chained_) {
            mpz_add(sum.get(), sum.get(), later.get());
        }
    }
}

} // namespace edgeproof::fixed_point
