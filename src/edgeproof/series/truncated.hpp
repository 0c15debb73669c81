// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace edgeproof::series {

/// A truncated power series c_0 + c_1 z + ... + c_{n-1} z^{n-1} + O(z^n) over a field T
/// (floating-point or symbolic). The result of an operation on two series has the smaller of their
/// orders. The coefficient of z^k has the unit of the function divided by that of z^k. No operation
/// uses finite differences.
template <class T> class Series {
public:
    Series() = default;
    /// The constant c with `order` terms. Throws DomainError for order 0.
    Series(const T& c, std::size_t order) : c_(order, T(0)) {
        if (order == 0) {
            throw DomainError("a truncated series needs at least one term");
        }
        c_[0] = c;
    }
    explicit Series(std::vector<T> coefficients) : c_(std::move(coefficients)) {
        if (c_.empty()) {
            throw DomainError("a truncated series needs at least one term");
        }
    }
    /// c + z with `order` terms.
    static Series variable(const T& c, std::size_t order) {
        Series s(c, order);
        if (order > 1) {
            s.c_[1] = T(1);
        }
        return s;
    }

    [[nodiscard]] std::size_t order() const noexcept { return c_.size(); }
    [[nodiscard]] const T& operator[](std::size_t k) const { return c_[k]; }
    T& operator[](std::size_t k) { return c_[k]; }
    [[nodiscard]] const std::vector<T>& coefficients() const noexcept { return c_; }
    [[nodiscard]] Series truncated(std::size_t order) const {
        return Series(std::vector<T>(
            c_.begin(), c_.begin() + static_cast<std::ptrdiff_t>(std::min(order, c_.size()))));
    }

    Series& operator+=(const Series& o) {
        c_.resize(std::min(order(), o.order()));
        for (std::size_t k = 0; k < c_.size(); ++k) {
            c_[k] += o.c_[k];
        }
        return *this;
    }
    Series& operator-=(const Series& o) {
        c_.resize(std::min(order(), o.order()));
        for (std::size_t k = 0; k < c_.size(); ++k) {
            c_[k] -= o.c_[k];
        }
        return *this;
    }
    Series& operator+=(const T& x) {
        c_[0] += x;
        return *this;
    }
    Series& operator-=(const T& x) {
        c_[0] -= x;
        return *this;
    }
    Series& operator*=(const T& x) {
        for (T& c : c_) {
            c *= x;
        }
        return *this;
    }
    Series& operator/=(const T& x) {
        for (T& c : c_) {
            c /= x;
        }
        return *this;
    }

    friend Series operator-(Series s) {
        for (T& c : s.c_) {
            c = -c;
        }
        return s;
    }
    friend Series operator+(Series x, const Series& y) { return x += y; }
    friend Series operator-(Series x, const Series& y) { return x -= y; }
    friend Series operator+(Series x, const T& y) { return x += y; }
    friend Series operator+(const T& x, Series y) { return y += x; }
    friend Series operator-(Series x, const T& y) { return x -= y; }
    friend Series operator-(const T& x, const Series& y) { return -y + x; }
    friend Series operator*(Series x, const T& y) { return x *= y; }
    friend Series operator*(const T& x, Series y) { return y *= x; }
    friend Series operator/(Series x, const T& y) { return x /= y; }

    friend Series operator*(const Series& x, const Series& y) {
        const std::size_t n = std::min(x.order(), y.order());
        Series r(T(0), n);
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t j = 0; i + j < n; ++j) {
                r.c_[i + j] += x.c_[i] * y.c_[j];
            }
        }
        return r;
    }
    /// The quotient, term by term from x = r y (`knuth1997`, section 4.7). Throws DomainError if
    /// the constant term of y is 0.
    friend Series operator/(const Series& x, const Series& y) {
        if (y.c_[0] == T(0)) {
            throw DomainError("division by a series with no constant term");
        }
        const std::size_t n = std::min(x.order(), y.order());
        Series r(T(0), n);
        for (std::size_t k = 0; k < n; ++k) {
            T sum = x.c_[k];
            for (std::size_t j = 1; j <= k; ++j) {
                sum -= y.c_[j] * r.c_[k - j];
            }
            r.c_[k] = sum / y.c_[0];
        }
        return r;
    }
    friend Series operator/(const T& x, const Series& y) { return Series(x, y.order()) / y; }

private:
    std::vector<T> c_;
};

/// d/dz, with one term less. Throws DomainError for a series of one term.
template <class T> [[nodiscard]] Series<T> derivative(const Series<T>& s) {
    if (s.order() < 2) {
        throw DomainError("the derivative of a series known to one term is unknown");
    }
    std::vector<T> d(s.order() - 1, T(0));
    for (std::size_t k = 1; k < s.order(); ++k) {
        d[k - 1] = s[k] * T(static_cast<int>(k));
    }
    return Series<T>(std::move(d));
}

/// The antiderivative with the constant term c, with one term more.
template <class T> [[nodiscard]] Series<T> antiderivative(const Series<T>& s, const T& c) {
    std::vector<T> r(s.order() + 1, T(0));
    r[0] = c;
    for (std::size_t k = 0; k < s.order(); ++k) {
        r[k + 1] = s[k] / T(static_cast<int>(k + 1));
    }
    return Series<T>(std::move(r));
}

/// f(g(z)) by Horner's rule. Throws DomainError if g has a constant term.
template <class T> [[nodiscard]] Series<T> compose(const Series<T>& f, const Series<T>& g) {
    if (!(g[0] == T(0))) {
        throw DomainError("the inner series of a composition has a constant term");
    }
    const std::size_t n = std::min(f.order(), g.order());
    Series<T> r(f[n - 1], n);
    for (std::size_t k = n - 1; k-- > 0;) {
        r = r * g.truncated(n);
        r[0] += f[k];
    }
    return r;
}

/// The series g with f(g(z)) = z for f = f_1 z + f_2 z^2 + ... (Lagrange's inversion, DLMF
/// 1.10(vii): g_n is the coefficient of z^{n-1} in (z/f)^n/n). Throws DomainError if f has a
/// constant term or f_1 vanishes.
template <class T> [[nodiscard]] Series<T> revert(const Series<T>& f) {
    if (!(f[0] == T(0)) || f.order() < 2 || f[1] == T(0)) {
        throw DomainError("only a series f_1 z + f_2 z^2 + ... with f_1 != 0 can be reverted");
    }
    const std::size_t n = f.order();
    const Series<T> shifted(std::vector<T>(f.coefficients().begin() + 1, f.coefficients().end()));
    const Series<T> base = T(1) / shifted;
    Series<T> g(T(0), n);
    Series<T> power = base;
    for (std::size_t k = 1; k < n; ++k) {
        g[k] = power[k - 1] / T(static_cast<int>(k));
        power = power * base;
    }
    return g;
}

/// y = x^p with y_0 = y0, for any exponent p in T, by x y' = p y x'
/// (`knuth1997`, section 4.7). Throws DomainError if x has no
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

} // namespace edgeproof::series
