// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/precision/fixed_point.hpp"

#include <algorithm>
#include <limits>

namespace edgeproof::fixed_point {
namespace {

/// How many terms up to the n-th, at the most, whose denominators have a product in one word.
std::size_t most_in_a_word(std::size_t n) {
    const unsigned long largest = 2 * n + 1;
    unsigned long rest = std::numeric_limits<unsigned long>::max();
    std::size_t count = 0;
    while (rest >= largest) {
        rest /= largest;
        ++count;
    }
    return count;
}

} // namespace

OddSeries::OddSeries(mp_bitcnt_t bits, unsigned zero_bits, bool alternating)
    : bits_(bits), zero_bits_(zero_bits), alternating_(alternating), length_(2) {
    const std::size_t last = bits_ / zero_bits_ + 1;
    while (length_ * length_ < last && length_ + 2 <= most_in_a_word(2 * last)) {
        length_ += 2;
    }
    for (std::size_t k = 0; k <= last; k += length_) {
        Block block;
        for (std::size_t j = k; j < k + length_; ++j) {
            block.denominator *= 2 * j + 1;
        }
        for (std::size_t j = k; j < k + length_; ++j) {
            block.numerators.push_back(block.denominator / (2 * j + 1));
        }
        blocks_.push_back(std::move(block));
    }
    powers_.resize(length_ + 1);
    mpz_setbit(powers_[0].get(), bits_);
}

/// Limbs that the factor s^k of a sum leaves without weight. One is kept beyond those that count,
/// so that what is cut off comes to less than 2^-bits in all.
mp_size_t OddSeries::unneeded(std::size_t k) const {
    const auto limbs = static_cast<mp_size_t>(k * zero_bits_ / GMP_NUMB_BITS);
    return std::clamp<mp_size_t>(limbs - 1, 0, static_cast<mp_size_t>(bits_ / GMP_NUMB_BITS));
}

// By blocks, and Horner's rule in s^length from the last, which needs few of the bits.
void OddSeries::sum(GmpInteger& sum, const GmpInteger& s) {
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
        mpz_fdiv_q_ui(block_.get(), block_.get(), block.denominator);
        mpz_mul(product_.get(), sum.get(), Upper(powers_[length_], cut).get());
        mpz_add(sum.get(), block_.get(), Upper(product_, limbs - unneeded(k + length_)).get());
    }
}

} // namespace edgeproof::fixed_point
