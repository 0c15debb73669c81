// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/arithmetic.hpp"
#include "edgeproof/series/truncated.hpp"

namespace edgeproof::quadrature {

/// The operations of a rule on the values that it adds: numbers, or truncated series, of which each
/// coefficient must converge.
template <class R> struct QuadratureValue;

template <Arithmetic T> struct QuadratureValue<T> {
    using Scalar = T;
    static T magnitude(const T& f) {
        using std::abs;
        return abs(f);
    }
    static void add(T& sum, const T& weight, const T& f) { sum += weight * f; }
    static void add_magnitude(T& sum, const T& weight, const T& f) {
        using std::abs;
        sum += abs(T(weight * f));
    }
    /// |x - y| in units of `scale`; for series the largest over the coefficients.
    static T distance(const T& x, const T& y, const T& scale) {
        using std::abs;
        const T d = abs(T(x - y));
        return scale > T(0) ? T(d / scale) : d;
    }
    static bool finite(const T& f) {
        using std::isfinite;
        return isfinite(f);
    }
};

template <Arithmetic T> struct QuadratureValue<series::Series<T>> {
    using Scalar = T;
    using One = QuadratureValue<T>;
    static void add(series::Series<T>& sum, const T& weight, const series::Series<T>& f) {
        for (std::size_t k = 0; k < sum.order(); ++k) {
            One::add(sum[k], weight, f[k]);
        }
    }
    static void add_magnitude(series::Series<T>& sum, const T& weight, const series::Series<T>& f) {
        for (std::size_t k = 0; k < sum.order(); ++k) {
            One::add_magnitude(sum[k], weight, f[k]);
        }
    }
    static T distance(const series::Series<T>& x, const series::Series<T>& y,
                      const series::Series<T>& scale) {
        T worst(0);
        for (std::size_t k = 0; k < x.order(); ++k) {
            const T d = One::distance(x[k], y[k], scale[k]);
            if (d > worst) {
                worst = d;
            }
        }
        return worst;
    }
    static bool finite(const series::Series<T>& f) {
        for (const T& c : f.coefficients()) {
            if (!One::finite(c)) {
                return false;
            }
        }
        return true;
    }
};

} // namespace edgeproof::quadrature
