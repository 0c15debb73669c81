// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace edgeproof {

/// Returns x^n for n > 0 by repeated squaring, for any type with products.
template <class T> [[nodiscard]] T repeated_product(const T& x, unsigned long n) {
    T square = x;
    while ((n & 1UL) == 0) {
        square = T(square * square);
        n >>= 1U;
    }
    T y = square;
    while ((n >>= 1U) != 0) {
        square = T(square * square);
        if ((n & 1UL) != 0) {
            y = T(y * square);
        }
    }
    return y;
}

/// Returns x^n for every n; `one` is 1 of the type, and 1/x is used where n < 0.
template <class T> [[nodiscard]] T power_by_squaring(const T& one, const T& x, long n) {
    return n == 0  ? one
           : n < 0 ? repeated_product(T(one / x), 0UL - static_cast<unsigned long>(n))
                   : repeated_product(x, static_cast<unsigned long>(n));
}

} // namespace edgeproof
