// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <vector>

/// The sizes of the slip zones as power series in the load ratio tau = |Q|/(f P), with P and
/// sigma_0/Q held, from the expansions of p at both edges (docs/partial-slip.md, "The series").
/// Over any field T with products and quotients by integers of type long.
namespace edgeproof::contact {

/// d = kappa_1 tau + kappa_2 tau^2 + ... (lengths); element 0 is kappa_1.
template <class T> struct SlipSeries {
    std::vector<T> right;
    std::vector<T> left;
};

namespace slip_series_detail {

/// The coefficients of x^0, x^1, ...
template <class T> using Power = std::vector<T>;

template <class T> Power<T> product(const Power<T>& x, const Power<T>& y, const T& zero) {
    Power<T> r(x.size(), zero);
    for (std::size_t i = 0; i < x.size(); ++i) {
        for (std::size_t j = 0; i + j < x.size(); ++j) {
            r[i + j] += x[i] * y[j];
        }
    }
    return r;
}

/// (1 - d/L)^(twice/2) for a series d without a constant term.
template <class T>
Power<T> half_power(const Power<T>& d, const T& L, long twice, const T& zero, const T& one) {
    // With x = 1 - d/L, n y_n is the sum over j of ((twice/2) j - (n - j)) x_j y_{n-j}
    // (`knuth1997`, section 4.7).
    Power<T> y(d.size(), zero);
    y[0] = one;
    for (std::size_t n = 1; n < d.size(); ++n) {
        T sum = zero;
        for (std::size_t j = 1; j <= n; ++j) {
            const long weight = (twice + 2) * static_cast<long>(j) - 2 * static_cast<long>(n);
            sum += d[j] * y[n - j] * weight;
        }
        y[n] = -(sum / L) / (2 * static_cast<long>(n));
    }
    return y;
}

/// The coefficient of tau^order of the left side of the equation for the slip zones
/// (docs/partial-slip.md, "The series"), divided by sqrt(D) pi/2. d is the slip zone at this edge,
/// e the one at the other edge; c and o are the coefficients of p at these edges. The left side is
///     integral of p sqrt((D - e - u)/(d - u)) du over 0 < u < d
///   + integral of p sqrt((e - u)/(D - d - u)) du over 0 < u < e (u from the other edge).
template <class T>
T balance(const std::vector<T>& c, const std::vector<T>& o, const Power<T>& d, const Power<T>& e,
          const T& D, std::size_t order, const T& zero, const T& one) {
    const std::size_t size = order + 1;
    const Power<T> near(d.begin(), d.begin() + static_cast<std::ptrdiff_t>(size));
    const Power<T> far(e.begin(), e.begin() + static_cast<std::ptrdiff_t>(size));
    // The sum over m of x^(m+first) B_m sum over j of c_{m-j} g_j L^(start - j), L = D - other,
    // where g_j are the coefficients of (1 - z)^(binomial/2) and B_m are beta functions.
    const auto sum = [&](const std::vector<T>& coefficients, const Power<T>& x,
                         const Power<T>& other, std::size_t first, long binomial, long beta_from,
                         long beta_over) {
        Power<T> total(size, zero);
        if (size <= first) {
            return total;
        }
        const std::size_t count = size - first;
        // (1 - other/D)^(binomial/2 - j)/D^j; the integral over the other zone has one power less.
        std::vector<Power<T>> powers;
        T scale = one;
        for (std::size_t j = 0; j < count; ++j) {
            Power<T> p = half_power(other, D, binomial - 2 * static_cast<long>(j), zero, one);
            for (T& v : p) {
                v *= scale;
            }
            powers.push_back(std::move(p));
            scale = scale / D;
        }
        std::vector<T> g{one};
        for (std::size_t j = 1; j < count; ++j) {
            const long k = static_cast<long>(j);
            g.push_back(g.back() * (2 * k - 2 - binomial) / (2 * k));
        }
        // B_0 = 1 for this zone (without the factor pi/2), 1/4 for the other zone.
        std::vector<T> beta{first == 1 ? one : T(one / 4)};
        for (std::size_t m = 1; m < count; ++m) {
            const long k = static_cast<long>(m) - 1;
            beta.push_back(beta.back() * (2 * k + beta_from) / (2 * k + beta_over));
        }
        for (std::size_t m = count; m-- > 0;) {
            total = product(total, x, zero);
            for (std::size_t j = 0; j <= m; ++j) {
                const T weight = coefficients[m - j] * g[j] * beta[m];
                for (std::size_t k = 0; k < size; ++k) {
                    total[k] += powers[j][k] * weight;
                }
            }
        }
        for (std::size_t k = 0; k < first; ++k) {
            total = product(total, x, zero);
        }
        return total;
    };
    // The ratios of B(m + 3/2, 1/2) and of B(m + 3/2, 3/2) (DLMF 5.12.1).
    const Power<T> here = sum(c, near, far, 1, 1, 3, 4);
    const Power<T> there = sum(o, far, near, 2, -1, 3, 6);
    return here[order] + there[order] / D;
}

} // namespace slip_series_detail

/// The first `terms` coefficients at both edges. `right` and `left` are the coefficients c_0, c_1,
/// ... of p, at least `terms` of each; `length` D = a + b; `lead` = 2 P/(pi sqrt(D)); `tension` =
/// P (sigma_0/Q)/(4 sqrt(D)); `one` is 1 in T. The first term gives d_1 = 2 s_0/(f c_0). Over balls
/// the coefficients are enclosed. The work grows like terms^4.
template <class T>
[[nodiscard]] SlipSeries<T> slip_series(const std::vector<T>& right, const std::vector<T>& left,
                                        const T& length, const T& lead, const T& tension,
                                        std::size_t terms, const T& one) {
    using namespace slip_series_detail;
    const T zero = one * 0L;
    Power<T> d(terms + 1, zero);
    Power<T> e(terms + 1, zero);
    // Each order follows from the lower ones: the equation is c_0 d plus terms of higher order.
    for (std::size_t n = 1; n <= terms; ++n) {
        // The right side of the equation: tau (lead +- tension (D - d - e)).
        const T stick = n == 1 ? length : T(-(d[n - 1] + e[n - 1]));
        const T by_force = n == 1 ? lead : zero;
        const T at_right =
            by_force + tension * stick - balance(right, left, d, e, length, n, zero, one);
        const T at_left =
            by_force - tension * stick - balance(left, right, e, d, length, n, zero, one);
        d[n] = at_right / right[0];
        e[n] = at_left / left[0];
    }
    return {{d.begin() + 1, d.end()}, {e.begin() + 1, e.end()}};
}

/// The sum of the first n terms at the load ratio tau, by Horner's rule (a length).
template <class T>
[[nodiscard]] T slip_sum(const std::vector<T>& kappa, std::size_t n, const T& tau) {
    T sum = kappa[n - 1];
    for (std::size_t k = n - 1; k-- > 0;) {
        sum = sum * tau + kappa[k];
    }
    return sum * tau;
}

} // namespace edgeproof::contact
