// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/arithmetic.hpp"
#include "edgeproof/precision/error.hpp"

#include <cmath>
#include <cstddef>

namespace edgeproof::roots {

/// A root between two places at which f has opposite signs, or an exact root.
template <class T> struct BracketedRoot {
    T x;
    T width; ///< the width of the last bracket, which contains a root of the computed f
    std::size_t evaluations = 0;
};

/// The root of a continuous f between lo and hi, where f_lo and f_hi have opposite signs, to a
/// bracket of at most `relative` times |x| (`chandrupatla1997`: inverse quadratic interpolation
/// where it is safe, else halving). Throws DomainError without a change of sign, BudgetError after
/// 400 evaluations.
template <Arithmetic T, class F>
[[nodiscard]] BracketedRoot<T> bracketed_root(const F& f, T lo, T f_lo, T hi, T f_hi,
                                              const T& relative) {
    using std::abs;
    using std::sqrt;
    if (f_lo == T(0)) {
        return {lo, T(0), 0};
    }
    if (f_hi == T(0)) {
        return {hi, T(0), 0};
    }
    if ((f_lo > T(0)) == (f_hi > T(0))) {
        throw DomainError("a root is not bracketed");
    }
    T fraction = T(1) / T(2);
    for (std::size_t n = 1; n <= 400; ++n) {
        // `lo` is the latest place, `hi` a place on the other side of the root, `old` the place
        // before `lo` or `hi`.
        const T x = lo + fraction * (hi - lo);
        const T f_x = f(x);
        if (f_x == T(0)) {
            return {x, T(0), n};
        }
        T old;
        T f_old;
        if ((f_x > T(0)) == (f_lo > T(0))) {
            old = lo;
            f_old = f_lo;
        } else {
            old = hi;
            f_old = f_hi;
            hi = lo;
            f_hi = f_lo;
        }
        lo = x;
        f_lo = f_x;
        const T width = abs(T(hi - lo));
        const bool lo_best = abs(f_lo) < abs(f_hi);
        const T best = lo_best ? lo : hi;
        const T allowed = relative * abs(best);
        if (width <= allowed) {
            return {best, width, n};
        }
        const T xi = (lo - hi) / (old - hi);
        const T phi = (f_lo - f_hi) / (f_old - f_hi);
        fraction = T(1) / T(2);
        if (phi * phi < xi && (T(1) - phi) * (T(1) - phi) < T(1) - xi) {
            // inverse quadratic interpolation through the three places
            fraction = f_lo / (f_hi - f_lo) * (f_old / (f_hi - f_old)) +
                       (old - lo) / (hi - lo) * (f_lo / (f_old - f_lo)) * (f_hi / (f_old - f_hi));
        }
        // Steps are at least long enough that the next place can end the search from the other
        // side.
        const T least = allowed / (T(2) * width);
        if (fraction < least) {
            fraction = least;
        } else if (fraction > T(1) - least) {
            fraction = T(1) - least;
        }
    }
    throw BudgetError("a bracketed root was not reached in 400 evaluations");
}

} // namespace edgeproof::roots
