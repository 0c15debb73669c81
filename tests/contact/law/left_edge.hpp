// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/law/edge_expansion.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace edgeproof::contact {

/// A polynomial q_0 + q_1 sigma + ... over a field T. A coefficient of a Series in u whose terms
/// are integrated over sigma.
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

private:
    void grow(std::size_t n) {
        if (q_.size() < n) {
            q_.resize(n, T(0));
        }
    }
    std::vector<T> q_;
};

/// The steps of the paper's derivation for the left edge (moore-hills EQ41 to EQ48;
/// docs/expansions.md, "The left edge"), u the distance from -b:
/// s = a + B sigma with B(u) = b^{-1}(b - u) - a, so that
/// p(-b + u) = -(B/u) sqrt(u)/(pi sqrt(D)) times the integral of
/// P'(a + B sigma) nearby^(-1/2) last^(-1/2) (1 - sigma)^(-1/2).
template <class T>
[[nodiscard]] std::vector<T> left_edge_brackets(const LawSeries<T>& law, const T& a) {
    using P = Polynomial<T>;
    const std::size_t n = std::min(law.force_rate.order(), law.b.order());
    const T D = a + law.b[0];
    series::Series<T> shift = law.b.truncated(n);
    shift[0] = T(0);
    // The series needs no further term of b, since B begins with u.
    series::Series<T> B = n > 1 ? revert(shift) : series::Series<T>(T(0), 1);
    for (std::size_t k = 1; k < n; k += 2) {
        B[k] = -B[k];
    }
    // Powers of B sigma as series in u, whose coefficients are polynomials in sigma.
    series::Series<P> step(P(T(0)), n);
    for (std::size_t k = 1; k < n; ++k) {
        step[k] = P::monomial(B[k], 1);
    }
    const auto along = [&](const series::Series<T>& f) {
        series::Series<P> sum(P(f[n - 1]), n);
        for (std::size_t k = n - 1; k-- > 0;) {
            sum = sum * step;
            sum[0] += P(f[k]);
        }
        return sum;
    };
    const series::Series<P> rate = along(law.force_rate);
    series::Series<P> nearby = step;
    for (std::size_t k = 0; k < n; ++k) {
        nearby[k] /= P(D);
    }
    nearby[0] += P(T(1));
    if (n > 1) {
        nearby[1] -= P(T(T(1) / D));
    }
    // x + b(s) = u + (b(a + B sigma) - b) vanishes identically at sigma = 1.
    const series::Series<P> gap = along(shift);
    std::vector<P> last;
    for (std::size_t k = 1; k < n; ++k) {
        P whole = gap[k];
        if (k == 1) {
            whole += P(T(1));
        }
        last.push_back(whole.over_one_minus_sigma());
    }
    // The highest term of `last` would need one more term of b than of P'; it is not used.
    const series::Series<P> root =
        last.empty() ? series::Series<P>(P(T(1)), 1) : series::Series<P>(std::move(last));
    const P minus_half(T(T(-1) / T(2)));
    const std::size_t m = root.order();
    const series::Series<P> product =
        rate.truncated(m) * pow_with_constant<P>(nearby.truncated(m), minus_half, P(T(1))) *
        pow_with_constant<P>(root, minus_half, P(T(1)));
    std::vector<T> integral;
    for (std::size_t k = 0; k < m; ++k) {
        integral.push_back(product[k].integrate_beta());
    }
    std::vector<T> brackets;
    if (n > 1) {
        for (std::size_t k = 0; k < m; ++k) {
            T sum(0);
            for (std::size_t j = 0; j <= k; ++j) {
                sum -= B[j + 1] * integral[k - j];
            }
            brackets.push_back(sum);
        }
    }
    return brackets;
}

} // namespace edgeproof::contact
