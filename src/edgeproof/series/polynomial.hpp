// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace edgeproof::series {

/// A polynomial q_0 + q_1 sigma + ... over a field T. It serves as a coefficient of a Series in u
/// whose terms are integrated over sigma (docs/expansions.md).
template <class T> class Polynomial {
public:
    Polynomial() = default;
    Polynomial(const T& c) : q_{c} {} // NOLINT: a scalar is a polynomial
    Polynomial(int c) : q_{T(c)} {}   // NOLINT: Series uses T(0), T(1)
    explicit Polynomial(std::vector<T> q) : q_(std::move(q)) {}
    /// c sigma^k
    static Polynomial monomial(const T& c, std::size_t k) {
        std::vector<T> q(k + 1, T(0));
        q[k] = c;
        return Polynomial(std::move(q));
    }

    [[nodiscard]] std::size_t size() const noexcept { return q_.size(); }
    [[nodiscard]] T operator[](std::size_t k) const { return k < q_.size() ? q_[k] : T(0); }

    Polynomial& operator+=(const Polynomial& o) {
        grow(o.size());
        for (std::size_t k = 0; k < o.size(); ++k) {
            q_[k] += o.q_[k];
        }
        return *this;
    }
    Polynomial& operator-=(const Polynomial& o) {
        grow(o.size());
        for (std::size_t k = 0; k < o.size(); ++k) {
            q_[k] -= o.q_[k];
        }
        return *this;
    }
    Polynomial& operator*=(const Polynomial& o) { return *this = *this * o; }
    /// Division by a constant polynomial only. Throws DomainError otherwise.
    Polynomial& operator/=(const Polynomial& o) {
        if (o.size() != 1) {
            throw DomainError("a polynomial can be divided only by a constant");
        }
        for (T& c : q_) {
            c /= o.q_[0];
        }
        return *this;
    }
    friend Polynomial operator-(Polynomial p) {
        for (T& c : p.q_) {
            c = -c;
        }
        return p;
    }
    friend Polynomial operator+(Polynomial x, const Polynomial& y) { return x += y; }
    friend Polynomial operator-(Polynomial x, const Polynomial& y) { return x -= y; }
    friend Polynomial operator/(Polynomial x, const Polynomial& y) { return x /= y; }
    friend Polynomial operator*(const Polynomial& x, const Polynomial& y) {
        if (x.size() == 0 || y.size() == 0) {
            return {};
        }
        std::vector<T> q(x.size() + y.size() - 1, T(0));
        for (std::size_t i = 0; i < x.size(); ++i) {
            for (std::size_t j = 0; j < y.size(); ++j) {
                q[i + j] += x.q_[i] * y.q_[j];
            }
        }
        return Polynomial(std::move(q));
    }
    /// Trailing zero coefficients do not count.
    friend bool operator==(const Polynomial& x, const Polynomial& y) {
        for (std::size_t k = 0; k < std::max(x.size(), y.size()); ++k) {
            if (!(x[k] == y[k])) {
                return false;
            }
        }
        return true;
    }

    /// The exact integral over 0 < sigma < 1 of the polynomial divided by sqrt(1 - sigma): the sum
    /// of q_j B(j+1, 1/2), with B(1, 1/2) = 2 and B(j+1, 1/2) = B(j, 1/2) 2j/(2j+1) (DLMF 5.12.1).
    [[nodiscard]] T integrate_beta() const {
        T sum(0);
        T beta(2);
        for (std::size_t j = 0; j < q_.size(); ++j) {
            if (j > 0) {
                beta *= T(static_cast<int>(2 * j));
                beta /= T(static_cast<int>(2 * j + 1));
            }
            sum += q_[j] * beta;
        }
        return sum;
    }

    /// The quotient by 1 - sigma without the remainder. The remainder is the value at sigma = 1,
    /// which must be zero.
    [[nodiscard]] Polynomial over_one_minus_sigma() const {
        std::vector<T> r;
        T partial(0);
        for (std::size_t k = 0; k + 1 < q_.size(); ++k) {
            partial += q_[k];
            r.push_back(partial);
        }
        return Polynomial(std::move(r));
    }
    [[nodiscard]] T at_one() const {
        T sum(0);
        for (const T& c : q_) {
            sum += c;
        }
        return sum;
    }

private:
    void grow(std::size_t n) {
        if (q_.size() < n) {
            q_.resize(n, T(0));
        }
    }
    std::vector<T> q_;
};

} // namespace edgeproof::series
