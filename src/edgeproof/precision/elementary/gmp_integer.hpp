// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <gmp.h>

namespace edgeproof {

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
