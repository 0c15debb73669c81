// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/precision/elementary/ratio_series.hpp"

#include "edgeproof/precision/bounded_cache.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <tuple>
#include <vector>

namespace edgeproof {
namespace {

/// The largest numbers of a group of terms: a limb of GMP, whose functions for one number take
/// `unsigned long`, which has only 32 bits on some systems (WebAssembly).
using Word = mp_limb_t;
constexpr bool word_is_long = sizeof(Word) == sizeof(unsigned long);

void multiply(mpz_ptr out, mpz_srcptr x, Word w) {
    if constexpr (word_is_long) {
        mpz_mul_ui(out, x, static_cast<unsigned long>(w));
    } else {
        mpz_t view;
        mpz_mul(out, x, mpz_roinit_n(view, &w, 1));
    }
}
void add_product(mpz_ptr out, mpz_srcptr x, Word w) {
    if constexpr (word_is_long) {
        mpz_addmul_ui(out, x, static_cast<unsigned long>(w));
    } else {
        mpz_t view;
        mpz_addmul(out, x, mpz_roinit_n(view, &w, 1));
    }
}
/// Rounds down.
void divide(mpz_ptr out, mpz_srcptr x, Word w) {
    if constexpr (word_is_long) {
        mpz_fdiv_q_ui(out, x, static_cast<unsigned long>(w));
    } else {
        mpz_t view;
        mpz_fdiv_q(out, x, mpz_roinit_n(view, &w, 1));
    }
}

constexpr double largest_argument = 0.999;
constexpr double most_ratio_terms = 1e6;
constexpr double largest_term = 1e100;
constexpr double largest_weight = 1e300;
/// The largest decrease over a block, in bits: within the range of a double.
constexpr double largest_fall = 600;
/// Every operation on doubles below has a relative error of at most 2^-53, and fewer than 1e8 of
/// them follow one another.
constexpr double rounded_up = 1 + 1e-7;

/// Consecutive terms with a common denominator, as many as fit into words:
///   s_k = (numerators . powers + last s_{k + count})/denominator.
struct Group {
    std::size_t first;
    std::size_t count;
    Word denominator;
    Word last;
};

/// The data of the sum that are valid for every number from 0 to x: the sizes of the terms in
/// doubles, and the groups.
class Summation {
public:
    Summation(const RatioSeries& of, double x, long bits) : of_(of), x_(x) {
        const double fall = -std::log2(x);
        const double terms = static_cast<double>(bits) / fall;
        const double length = std::min(std::sqrt(terms), largest_fall / fall);
        block_ = static_cast<std::size_t>(std::max(1.0, length));
        ok_ = fall < largest_fall && count_terms(bits) && make_groups();
    }

    [[nodiscard]] bool ok() const { return ok_; }
    [[nodiscard]] std::size_t terms() const { return terms_; }
    [[nodiscard]] std::size_t block() const { return block_; }
    [[nodiscard]] const std::vector<Group>& groups() const { return groups_; }
    [[nodiscard]] const Word* numerators(const Group& g) const {
        return numerators_.data() + g.first;
    }
    /// The errors in the block that contains k and in later blocks are multiplied by at most
    /// 2^this.
    [[nodiscard]] long log2_weight(std::size_t k) const { return log2_weights_[k / block_]; }
    /// The remainder is below tail() 2^tail_exponent().
    [[nodiscard]] double tail() const { return tail_; }
    [[nodiscard]] long tail_exponent() const { return tail_exponent_; }
    /// A bound of the derivative of the sum by x on the whole ball.
    [[nodiscard]] double derivative() const { return derivative_; }
    /// The sum of the weights of all errors. The weight of a term is c_k times the power of x with
    /// which its block begins; the weight of the power that leads from one block to the one before
    /// is the value of all that follows, without that power.
    [[nodiscard]] double weight() const { return weight_; }

private:
    /// Smaller terms are scaled by a power of two, which is counted separately.
    static constexpr int small_exponent = -300;
    static constexpr double small_term = 0x1p-300;

    [[nodiscard]] double ratio(double k) const {
        double over = 1;
        double under = 1;
        for (const auto& q : of_.quotients) {
            const double from = static_cast<double>(q.slope) * k;
            over *= from + static_cast<double>(q.over);
            under *= from + static_cast<double>(q.under);
        }
        return over / under;
    }
    /// A bound of this and all later ratios.
    [[nodiscard]] double most_ratio(double k) const {
        double r = 1;
        for (const auto& q : of_.quotients) {
            const double from = static_cast<double>(q.slope) * k;
            r *= std::max(1.0, (from + static_cast<double>(q.over)) /
                                   (from + static_cast<double>(q.under)));
        }
        return r;
    }
    void close_block(double most, long exponent) {
        if (most > 0) {
            log2_weights_.push_back(std::ilogb(most * rounded_up) + 1 + exponent);
        }
    }
    bool count_terms(long bits) {
        double term = 1;   // c_k x^k over 2^exponent
        double weight = 1; // c_k times the power with which the block begins, over 2^exponent
        double passed = 0; // the sum of k/block c_k x^k
        long exponent = 0;
        const double least = std::ldexp(1.0, -static_cast<int>(std::min(bits, 1000L)));
        double most_weight = 0; // of the block, over 2^exponent
        double unit = 1;        // 2^exponent, if a double can represent it
        std::size_t blocks = 0;
        for (std::size_t k = 0;; ++k) {
            const auto at = static_cast<double>(k);
            const bool small = exponent == 0 ? term < least : std::ilogb(term) + exponent < -bits;
            const double falls = small ? most_ratio(at) * x_ * rounded_up : 1;
            const double rest = term / (1 - falls) * rounded_up;
            if (falls < 1 && std::ilogb(rest) + exponent < -bits - 4) {
                terms_ = k;
                tail_ = rest;
                tail_exponent_ = exponent;
                // The terms that are small enough to be scaled add up to less than 1.
                derivative_ += exponent == 0 ? rest * (at + 1) / (1 - falls) : 1;
                derivative_ *= rounded_up / x_;
                passed *= std::pow(x_, -static_cast<double>(block_));
                weight_ = (weight_ + passed + 1) * rounded_up;
                close_block(most_weight, exponent);
                for (std::size_t b = log2_weights_.size(); b-- > 1;) {
                    log2_weights_[b - 1] = std::max(log2_weights_[b - 1], log2_weights_[b]);
                }
                return true;
            }
            if (k == blocks * block_) {
                close_block(most_weight, exponent);
                weight = most_weight = term;
                ++blocks;
            }
            const double r = ratio(at);
            most_weight = std::max(most_weight, weight * std::max(r, 1.0));
            weight_ += weight * unit;
            passed += static_cast<double>(blocks - 1) * (term * unit);
            if (exponent == 0) {
                derivative_ += at * term;
            }
            term *= r * x_;
            weight *= r;
            if (at > most_ratio_terms || term > largest_term || weight > largest_weight) {
                return false;
            }
            while (term < small_term) {
                term = std::ldexp(term, -small_exponent);
                weight = std::ldexp(weight, -small_exponent);
                most_weight = std::ldexp(most_weight, -small_exponent);
                exponent += small_exponent;
                unit = std::ldexp(1.0, static_cast<int>(std::max(exponent, -1000L)));
            }
        }
    }
    /// Returns a_k and b_k of the ratio a_k/b_k, for a k for which `size` shows that they are
    /// words.
    [[nodiscard]] std::pair<Word, Word> words(std::size_t k) const {
        Word over = 1;
        Word under = 1;
        for (const auto& q : of_.quotients) {
            const Word from = static_cast<Word>(q.slope) * k;
            over *= from + static_cast<Word>(q.over);
            under *= from + static_cast<Word>(q.under);
        }
        return {over, under};
    }
    /// Returns an upper bound of both.
    [[nodiscard]] double size(std::size_t k) const {
        double most = rounded_up;
        for (const auto& q : of_.quotients) {
            most *= static_cast<double>(q.slope) * static_cast<double>(k) +
                    static_cast<double>(std::max(q.over, q.under));
        }
        return most;
    }
    bool make_groups() {
        constexpr auto largest = static_cast<double>(std::numeric_limits<Word>::max()) / 2;
        std::vector<std::pair<Word, Word>> of_group;
        numerators_.resize(terms());
        std::size_t block_end = block_;
        for (std::size_t k = 0; k < terms();) {
            of_group.clear();
            double most = 1;
            const std::size_t end = std::min(terms(), block_end);
            for (std::size_t i = k; i < end && (most *= size(i)) < largest; ++i) {
                of_group.push_back(words(i));
            }
            if (of_group.empty()) {
                return false;
            }
            Word under = 1;
            for (std::size_t i = of_group.size(); i-- > 0;) {
                under *= of_group[i].second;
                numerators_[k + i] = under;
            }
            Word over = 1;
            for (std::size_t i = 0; i < of_group.size(); ++i) {
                numerators_[k + i] *= over;
                over *= of_group[i].first;
            }
            groups_.push_back({k, of_group.size(), under, over});
            k += of_group.size();
            block_end += k == block_end ? block_ : 0;
        }
        return true;
    }

    RatioSeries of_;
    double x_;
    std::size_t block_;
    std::size_t terms_ = 0;
    std::vector<long> log2_weights_;
    std::vector<Group> groups_;
    std::vector<Word> numerators_;
    double tail_ = 0;
    long tail_exponent_ = 0;
    double derivative_ = 0;
    double weight_ = 0;
    bool ok_;
};

/// Returns the summation for x or a slightly larger number. Neighbouring x have the same one; each
/// thread caches them.
std::shared_ptr<const Summation> summation_of(const RatioSeries& series, double x, long bits) {
    constexpr double steps = 64; // from 0 to 1, so that an octave has half as many
    constexpr double most_kept = 0.95;
    constexpr std::size_t most_series_kept = 256;
    constexpr double most_terms_kept = 1U << 14;
    int exponent = 0;
    const double above = std::ceil(std::frexp(x, &exponent) * steps);
    const double most = std::ldexp(above / steps, exponent);
    if (x > most_kept || static_cast<double>(bits) > -std::log2(most) * most_terms_kept) {
        return std::make_shared<const Summation>(series, x, bits);
    }
    using Key = std::tuple<RatioSeries, double, int, long>;
    thread_local BoundedCache<Key, const Summation> kept(most_series_kept);
    return kept.get(Key{series, above, exponent, bits},
                    [&] { return std::make_shared<const Summation>(series, most, bits); });
}

} // namespace

// Sums by Horner's rule in fixed-point numbers, in blocks whose powers of x come from a table, so
// that inside a block numbers are multiplied by single words only (rectangular splitting). A block
// uses the limbs that its weights require and one more; what this drops is less than one unit in
// total. Otherwise every division and product drops less than a unit, and x^j has an error of less
// than 2j units.
std::optional<Ball> RatioSeries::sum(const Ball& x, long bits) const {
    const double most_x = std::nextafter(arf_get_d(arb_midref(x.data()), ARF_RND_UP), 1.0) +
                          mag_get_d(arb_radref(x.data()));
    if (!certainly_positive(x) || !(most_x < largest_argument) || x.relative_accuracy_bits() < 20) {
        return std::nullopt;
    }
    const std::shared_ptr<const Summation> kept = summation_of(*this, most_x * rounded_up, bits);
    const Summation& plan = *kept;
    if (!plan.ok()) {
        return std::nullopt;
    }
    const double errors = (3 * static_cast<double>(plan.block()) + 4) * plan.weight();
    if (!(errors < largest_weight)) {
        return std::nullopt;
    }
    const long whole = (bits + std::ilogb(errors) + 6 + GMP_NUMB_BITS - 1) / GMP_NUMB_BITS;
    const auto limbs = static_cast<mp_size_t>(whole);
    const auto fixed_bits = static_cast<mp_bitcnt_t>(whole * GMP_NUMB_BITS);

    // One power for each term of the longest block so far, at most a thousand.
    thread_local std::vector<GmpInteger> powers;
    thread_local GmpInteger s;
    thread_local GmpInteger work;
    if (powers.size() < plan.block() + 1) {
        powers.resize(plan.block() + 1);
    }
    mpz_set_ui(powers[0].get(), 0);
    mpz_setbit(powers[0].get(), fixed_bits);
    FmpzValue scaled;
    arf_get_fmpz_fixed_si(scaled, arb_midref(x.data()), -static_cast<slong>(fixed_bits));
    fmpz_get_mpz(powers[1].get(), scaled);
    for (std::size_t j = 2; j <= plan.block(); ++j) {
        mpz_mul(work.get(), powers[j / 2].get(), powers[j - j / 2].get());
        mpz_set(powers[j].get(), Upper(work, limbs).get());
    }
    const auto unneeded = [&](std::size_t k) {
        return std::clamp<mp_size_t>(-plan.log2_weight(k) / GMP_NUMB_BITS - 1, 0, limbs - 1);
    };
    mpz_set_ui(s.get(), 0);
    mp_size_t cut = 0; // number of limbs of s that are dropped
    for (std::size_t i = plan.groups().size(); i-- > 0;) {
        const Group& g = plan.groups()[i];
        const std::size_t end = g.first + g.count;
        const mp_size_t here = unneeded(g.first);
        if (end == plan.terms()) {
            cut = here;
        } else if (end % plan.block() == 0) {
            mpz_mul(work.get(), s.get(), Upper(powers[plan.block()], here).get());
            mpz_set(s.get(), Upper(work, limbs - cut).get());
            cut = here;
        }
        const Word* numerator = plan.numerators(g);
        multiply(work.get(), s.get(), g.last);
        for (std::size_t j = 0; j < g.count; ++j) {
            add_product(work.get(), Upper(powers[(g.first + j) % plan.block()], cut).get(),
                        numerator[j]);
        }
        divide(s.get(), work.get(), g.denominator);
    }

    Ball result(0, bits);
    FmpzValue value;
    fmpz_set_mpz(value, s.get());
    arf_set_fmpz(arb_midref(result.data()), value);
    arb_mul_2exp_si(result.data(), result.data(), -static_cast<slong>(fixed_bits));
    MagValue error;
    const auto add_error = [&](double size, long exponent) {
        mag_set_d(error, size);
        mag_mul_2exp_si(error, error, exponent);
        arb_add_error_mag(result.data(), error);
    };
    add_error(errors, -static_cast<long>(fixed_bits));
    add_error(plan.tail(), plan.tail_exponent());
    mag_set_d(error, plan.derivative());
    mag_mul(error, error, arb_radref(x.data()));
    arb_add_error_mag(result.data(), error);
    arb_set_round(result.data(), result.data(), bits);
    return result;
}

} // namespace edgeproof
