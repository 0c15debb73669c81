// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/arithmetic.hpp"
#include "edgeproof/series/truncated.hpp"

#include <cmath>

/// Elementary functions of truncated series, each by the recurrence that follows from its
/// differential equation (`knuth1997`, section 4.7, for powers; derivatives of DLMF 4.7, 4.20,
/// 4.24(ii), 4.38(ii)). The constant term is the function in T.
namespace edgeproof::series {

/// y = x^p with y_0 = y0, for any exponent p in T, by x y' = p y x'. Throws DomainError if x has no
/// constant term.
template <class T> [[nodiscard]] Series<T> pow_with_constant(const Series<T>& x, const T& p, T y0) {
    if (x[0] == T(0)) {
        throw DomainError("a power of a series with no constant term");
    }
    Series<T> y(y0, x.order());
    for (std::size_t n = 1; n < x.order(); ++n) {
        T sum(0);
        for (std::size_t j = 1; j <= n; ++j) {
            sum += (p * T(static_cast<int>(j)) - T(static_cast<int>(n - j))) * x[j] * y[n - j];
        }
        y[n] = sum / (T(static_cast<int>(n)) * x[0]);
    }
    return y;
}

template <class T> [[nodiscard]] Series<T> sqrt(const Series<T>& x) {
    using std::sqrt;
    return pow_with_constant<T>(x, T(1) / T(2), sqrt(x[0]));
}

/// x^n by repeated squaring; n < 0 needs a constant term.
template <class T> [[nodiscard]] Series<T> pow_int(const Series<T>& x, long n) {
    if (n < 0) {
        return pow_int(T(1) / x, -n);
    }
    Series<T> y(T(1), x.order());
    for (Series<T> square = x; n != 0; n /= 2) {
        y = n % 2 != 0 ? y * square : y;
        square = n > 1 ? square * square : square;
    }
    return y;
}

/// The series f with f(x_0) = f0 and f' = g x' for a known g: the common form of log, atan, asin,
/// ...
template <class T>
[[nodiscard]] Series<T> integrate_along(const Series<T>& g, const Series<T>& x, const T& f0) {
    if (x.order() == 1) {
        return Series<T>(f0, 1);
    }
    return antiderivative(g.truncated(x.order() - 1) * derivative(x), f0);
}
/// The same for g = rate(), which is infinite at an end of the domain of f: one term needs no g.
template <class T, class Rate>
[[nodiscard]] Series<T> integrate_root(const Rate& rate, const Series<T>& x, const T& f0) {
    return x.order() == 1 ? Series<T>(f0, 1) : integrate_along(rate(), x, f0);
}

template <class T> [[nodiscard]] Series<T> log(const Series<T>& x) {
    using std::log;
    return integrate_along(T(1) / x, x, T(log(x[0])));
}

/// exp x, by y' = y x'.
template <class T> [[nodiscard]] Series<T> exp(const Series<T>& x) {
    using std::exp;
    Series<T> y(T(exp(x[0])), x.order());
    for (std::size_t n = 1; n < x.order(); ++n) {
        T sum(0);
        for (std::size_t j = 1; j <= n; ++j) {
            sum += T(static_cast<int>(j)) * x[j] * y[n - j];
        }
        y[n] = sum / T(static_cast<int>(n));
    }
    return y;
}

template <class T> [[nodiscard]] Series<T> atan(const Series<T>& x) {
    using std::atan;
    return integrate_along(T(1) / (T(1) + x * x), x, T(atan(x[0])));
}

template <class T> [[nodiscard]] Series<T> asin(const Series<T>& x) {
    using std::asin;
    return integrate_root([&] { return T(1) / sqrt(T(1) - x * x); }, x, T(asin(x[0])));
}

template <class T> [[nodiscard]] Series<T> acos(const Series<T>& x) {
    using std::acos;
    return integrate_root([&] { return T(-1) / sqrt(T(1) - x * x); }, x, T(acos(x[0])));
}

/// sin x and cos x together, by s' = c x', c' = -s x'.
template <class T> [[nodiscard]] std::pair<Series<T>, Series<T>> sin_cos(const Series<T>& x) {
    using std::cos;
    using std::sin;
    Series<T> s(T(sin(x[0])), x.order());
    Series<T> c(T(cos(x[0])), x.order());
    for (std::size_t n = 1; n < x.order(); ++n) {
        T sum_s(0);
        T sum_c(0);
        for (std::size_t j = 1; j <= n; ++j) {
            const T jx = T(static_cast<int>(j)) * x[j];
            sum_s += jx * c[n - j];
            sum_c -= jx * s[n - j];
        }
        s[n] = sum_s / T(static_cast<int>(n));
        c[n] = sum_c / T(static_cast<int>(n));
    }
    return {s, c};
}
template <class T> [[nodiscard]] Series<T> sin(const Series<T>& x) { return sin_cos(x).first; }
template <class T> [[nodiscard]] Series<T> cos(const Series<T>& x) { return sin_cos(x).second; }
} // namespace edgeproof::series
