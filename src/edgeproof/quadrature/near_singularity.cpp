// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/quadrature/near_singularity.hpp"
#include "edgeproof/precision/arithmetic.hpp"
#include "edgeproof/precision/elementary/elementary.hpp"

#include <cmath>

namespace edgeproof::quadrature {

template <Arithmetic T, class R>
QuadratureResult<R> integrate_one_sided_of(const IntegrandRef<T, R>& f, const T& length,
                                           const T& beyond, bool at_lo,
                                           const QuadratureOptions& options) {
    using std::log1p;
    if (beyond > T(0) && beyond < length / T(8)) {
        const T y_end = log1p(T(length / beyond));
        const T whole = length + beyond;
        const T half = T(1) / T(2);
        auto result = tanh_sinh<T>(
            [&](const T& lo, const T& hi) {
                const T& y = at_lo ? lo : hi;
                const T& y_rest = at_lo ? hi : lo;
                // The double exponential rule (takahasi-mori1974) in y with
                // r = beyond (e^(y_end y) - 1), rest = whole (1 - e^(-y_end y_rest)), and
                // dr = y_end (r + beyond) dy. The larger of r and rest is the length less the
                // other, so that only one exponential is needed.
                const T to_go = y_end * y_rest;
                T r;
                T rest;
                if (to_go < half) {
                    rest = -whole * exp_less_one(T(-to_go));
                    r = length - rest;
                } else {
                    r = beyond * exp_less_one(T(y_end * y));
                    rest = length - r;
                }
                return R((at_lo ? f(r, rest) : f(rest, r)) * T(r + beyond));
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

template <Arithmetic T, class R>
QuadratureResult<R> integrate_near_of(const IntegrandRef<T, R>& f, const T& length,
                                      const T& beyond_lo, const T& beyond_hi,
                                      const QuadratureOptions& options) {
    const T close = length / T(8);
    const bool near_lo = beyond_lo > T(0) && beyond_lo < close;
    const bool near_hi = beyond_hi > T(0) && beyond_hi < close;
    if (!(near_lo && near_hi)) {
        return integrate_one_sided_of<T, R>(f, length, near_hi ? beyond_hi : beyond_lo, !near_hi,
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

#define EDGEPROOF_INSTANTIATE(T)                                                                   \
    template QuadratureResult<T> integrate_one_sided_of(const IntegrandRef<T, T>&, const T&,       \
                                                        const T&, bool, const QuadratureOptions&); \
    template QuadratureResult<T> integrate_near_of(const IntegrandRef<T, T>&, const T&, const T&,  \
                                                   const T&, const QuadratureOptions&);
EDGEPROOF_FOR_EACH_ARITHMETIC(EDGEPROOF_INSTANTIATE)
#undef EDGEPROOF_INSTANTIATE

} // namespace edgeproof::quadrature
