// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/quadrature/tanh_sinh.hpp"

#include <utility>
#include <vector>

namespace edgeproof {

/// The integral of f over an interval of length L when f has a singularity *outside*, `beyond`
/// away from one end (0: none known). One that is near would slow tanh-sinh down without end; the
/// map r = beyond (e^y - 1) moves it to y = -i pi whatever its distance. f is called with the
/// distances from both ends, both exact.
template <Arithmetic T, class F>
auto integrate_one_sided(const F& f, const T& length, const T& beyond, bool at_lo,
                         const QuadratureOptions& options = {}) {
    using std::expm1;
    using std::log1p;
    if (beyond > T(0) && beyond < length / T(8)) {
        const T y_end = log1p(T(length / beyond));
        const T whole = length + beyond;
        auto result = tanh_sinh<T>(
            [&](const T& lo, const T& hi) {
                const T& y = at_lo ? lo : hi;
                const T& y_rest = at_lo ? hi : lo;
                const T grown = expm1(T(y_end * y));
                const T r = beyond * grown;
                const T rest = -whole * expm1(T(-(y_end * y_rest)));
                return (at_lo ? f(r, rest) : f(rest, r)) * T(beyond * (grown + T(1)));
            },
            options);
        result.value = result.value * y_end;
        return result;
    }
    auto result = tanh_sinh<T>(
        [&](const T& lo, const T& hi) { return f(T(length * lo), T(length * hi)); }, options);
    result.value = result.value * length;
    return result;
}

/// The same with singularities beyond both ends: halved where both are near.
template <Arithmetic T, class F>
auto integrate_near(const F& f, const T& length, const T& beyond_lo, const T& beyond_hi,
                    const QuadratureOptions& options = {}) {
    const T close = length / T(8);
    const bool near_lo = beyond_lo > T(0) && beyond_lo < close;
    const bool near_hi = beyond_hi > T(0) && beyond_hi < close;
    if (!(near_lo && near_hi)) {
        return integrate_one_sided<T>(f, length, near_hi ? beyond_hi : beyond_lo, !near_hi,
                                      options);
    }
    const T half = length / T(2);
    auto left =
        integrate_one_sided<T>([&](const T& lo, const T& hi) { return f(lo, T(half + hi)); }, half,
                               beyond_lo, true, options);
    const auto right =
        integrate_one_sided<T>([&](const T& lo, const T& hi) { return f(T(half + lo), hi); }, half,
                               beyond_hi, false, options);
    left.add(right);
    return left;
}

/// The integral over consecutive intervals given by their lengths: each is told how far beyond its
/// ends the next cut lies; `beyond_first` and `beyond_last` say it for the outermost ends (0: no
/// singularity there). f is called as f(i, lo, hi) on interval i.
template <Arithmetic T, class F>
auto integrate_pieces(const F& f, const std::vector<T>& lengths, const T& beyond_first,
                      const T& beyond_last, const QuadratureOptions& options = {}) {
    using R = std::remove_cvref_t<decltype(f(std::size_t{}, lengths[0], lengths[0]))>;
    std::optional<QuadratureResult<R>> total;
    for (std::size_t i = 0; i < lengths.size(); ++i) {
        if (!(lengths[i] > T(0))) {
            continue;
        }
        auto part =
            integrate_near<T>([&](const T& lo, const T& hi) { return f(i, lo, hi); }, lengths[i],
                              i > 0 ? lengths[i - 1] : beyond_first,
                              i + 1 < lengths.size() ? lengths[i + 1] : beyond_last, options);
        if (!total) {
            total = std::move(part);
        } else {
            total->add(part);
        }
    }
    if (!total) {
        throw DomainError("an integral over no interval at all");
    }
    return std::move(*total);
}

} // namespace edgeproof
