// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/ball/ball.hpp"

#include <gmp.h>

#include <array>
#include <compare>
#include <optional>

namespace edgeproof {

/// The sum of c_k x^k over k, c_0 = 1, where c_{k+1}/c_k is a product of two quotients
/// (slope k + over)/(slope k + under) of positive integers: Gauss's 2F1 with rational parameters
/// (DLMF 15.2.1).
struct RatioSeries {
    // clang-tidy 14 takes the 0 of a defaulted <=> for a pointer.
    // NOLINTBEGIN(modernize-use-nullptr)
    struct Quotient {
        long slope;
        long over;
        long under;
        [[nodiscard]] auto operator<=>(const Quotient&) const = default;
    };
    std::array<Quotient, 2> quotients;
    [[nodiscard]] auto operator<=>(const RatioSeries&) const = default;
    // NOLINTEND(modernize-use-nullptr)

    /// Returns an enclosure of the sum for every number of the ball x, 0 < x < 1. Nothing if the
    /// ball is wide, reaches 0.999, or lies below 2^-600, or if the numbers do not fit into words;
    /// then the caller uses slower methods.
    /// @param x argument
    /// @param bits working precision
    [[nodiscard]] std::optional<Ball> sum(const Ball& x, long bits) const;
};

/// An integer of GMP. As a fixed-point number it counts units of a power of two.
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

/// A view of a non-negative number without its last limbs. The limbs are not copied, so that it
/// must be used before the number changes.
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

} // namespace edgeproof
