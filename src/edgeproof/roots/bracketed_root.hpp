// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/arithmetic.hpp"
#include "edgeproof/precision/error.hpp"

#include <cmath>
#include <cstddef>
#include <utility>

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

/// The place of the minimum of a function with one minimum in (lo, hi), by golden section
/// (`kiefer1953`): each step needs one evaluation and shrinks the interval by the factor 0.618.
/// There is no proved bound. Near a minimum the values are flat, so that only half the digits of
/// Number can be reached. The search ends when `found(value)` is true for either of the two current
/// values.
template <class Number, class Function, class Found>
[[nodiscard]] Number place_of_minimum(const Function& f, Number lo, Number hi, int steps,
                                      const Found& found) {
    using std::sqrt;
    const Number golden = (sqrt(Number(5)) - 1) / 2;
    Number x = hi - golden * (hi - lo);
    Number y = lo + golden * (hi - lo);
    Number at_x = f(x);
    Number at_y = f(y);
    for (int k = 0; k < steps && !found(at_x) && !found(at_y); ++k) {
        if (at_x < at_y) {
            hi = y;
            y = x;
            at_y = at_x;
            x = hi - golden * (hi - lo);
            at_x = f(x);
        } else {
            lo = x;
            x = y;
            at_x = at_y;
            y = lo + golden * (hi - lo);
            at_y = f(y);
        }
    }
    return at_x < at_y ? x : y;
}

template <class Number, class Function>
[[nodiscard]] Number place_of_minimum(const Function& f, Number lo, Number hi, int steps) {
    return place_of_minimum(f, std::move(lo), std::move(hi), steps,
                            [](const Number&) { return false; });
}

} // namespace edgeproof::roots
