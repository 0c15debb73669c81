// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/law/field.hpp"
#include "edgeproof/precision/ball/ball.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/series/truncated.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace edgeproof::contact {

/// P'(a + z) and b(a + z) as truncated series in z, the input of an edge expansion. Units of the
/// coefficients of z^k: force per unit length over length^(k+1), and length^(1-k).
template <class T> struct LawSeries {
    series::Series<T> force_rate; ///< dP/da, the total derivative along the family of contacts
    series::Series<T> b;          ///< b(a + z); a + z itself for a symmetric contact
};

[[nodiscard]] constexpr std::size_t nth(int k) { return static_cast<std::size_t>(k); }

/// Returns the first terms of the product of two series: as many as `f` has, minus `dropped`.
template <class T>
[[nodiscard]] std::vector<T> series_product(const std::vector<T>& f, const std::vector<T>& g,
                                            std::size_t dropped) {
    std::vector<T> h;
    for (std::size_t k = 0; k + dropped < f.size(); ++k) {
        T sum = f[0] * g[k];
        for (std::size_t j = 1; j <= k; ++j) {
            sum += f[j] * g[k - j];
        }
        h.push_back(std::move(sum));
    }
    return h;
}

/// The same for balls: Arb rounds a dot product once.
[[nodiscard]] inline std::vector<Ball>
series_product(const std::vector<Ball>& f, const std::vector<Ball>& g, std::size_t dropped) {
    // Shallow copies, which are not cleared.
    const auto views = [](const std::vector<Ball>& list) {
        std::vector<arb_struct> all;
        for (const Ball& x : list) {
            all.push_back(*x.data());
        }
        return all;
    };
    const std::vector<arb_struct> of_f = views(f);
    const std::vector<arb_struct> of_g = views(g);
    std::vector<Ball> h;
    for (std::size_t k = 0; k + dropped < f.size(); ++k) {
        Ball sum(0, f[0].bits());
        arb_dot(sum.data(), nullptr, 0, of_f.data(), 1, of_g.data() + k, -1,
                static_cast<slong>(k + 1), sum.bits());
        h.push_back(std::move(sum));
    }
    return h;
}

/// The brackets r_k of the coefficients c_k = r_k/(pi sqrt(a + b)) at the right edge, over any
/// field T, symbols included (docs/expansions.md, "The right edge"). With s = a - u sigma in
/// moore-hills EQ21 (first branch), p(a - u) is sqrt(u)/(pi sqrt(D)) times the integral over
/// 0 < sigma < 1 of
/// P'(a - u sigma) (1 - sigma)^(-1/2) [(x + b(s))/D]^(-1/2), D = a + b.
/// With w = u sigma, (x + b(s))/D = g(w) - u/D, g(w) = (a + b(a - w))/D, so that the root is the
/// sum over m of binomial(-1/2, m) (-u/D)^m g(w)^(-1/2 - m): one series in w for each m.
/// `law` holds P'(a + z) and b(a + z); the result has as many brackets as these series have terms.
template <class T>
[[nodiscard]] std::vector<T> right_edge_brackets(const LawSeries<T>& law, const T& a) {
    const auto n = static_cast<int>(std::min(law.force_rate.order(), law.b.order()));
    const T D = a + law.b[0];
    const T zero = Field<T>::number(0, D);
    std::vector<T> g{Field<T>::number(1, D)};
    std::vector<T> rate; // P'(a - w)
    for (int k = 0; k < n; ++k) {
        const int sign = k % 2 == 0 ? 1 : -1;
        rate.push_back(T(law.force_rate[nth(k)] * sign));
        if (k > 0) {
            g.push_back(T(law.b[nth(k)] / D * sign));
        }
    }
    // g^(-1/2) and 1/g, by k g_0 (g^p)_k = sum over j of (p j - (k - j)) g_j (g^p)_{k-j}
    // (`knuth1997`, section 4.7).
    std::vector<T> root{g[0]};
    std::vector<T> inverse{g[0]};
    for (int k = 1; k < n; ++k) {
        T of_root = zero;
        T of_inverse = zero;
        for (int j = 1; j <= k; ++j) {
            of_root += g[nth(j)] * root[nth(k - j)] * (j - 2 * k);
            of_inverse -= g[nth(j)] * inverse[nth(k - j)];
        }
        root.push_back(T(of_root / (2 * k)));
        inverse.push_back(std::move(of_inverse));
    }
    // The integral of sigma^j (1 - sigma)^(-1/2) is B(j + 1, 1/2) (DLMF 5.12.1).
    std::vector<T> beta{Field<T>::number(2, D)};
    for (int j = 1; j < n; ++j) {
        beta.push_back(T(beta.back() * (2 * j) / (2 * j + 1)));
    }
    std::vector<T> brackets(nth(n), zero);
    std::vector<T> power = series_product(rate, root, 0); // P'(a - w) g(w)^(-1/2 - m)
    T factor = Field<T>::number(1, D);                    // binomial(-1/2, m) (-1/D)^m
    for (int m = 0; m < n; ++m) {
        check_interruption();
        for (int l = 0; m + l < n; ++l) {
            brackets[nth(m + l)] += factor * power[nth(l)] * beta[nth(l)];
        }
        power = series_product(power, inverse, 1);
        factor = factor * (2 * m + 1) / (D * (2 * m + 2));
    }
    return brackets;
}

/// c_k = r_k/(pi sqrt(a + b)) for the brackets of either edge; `length` is a + b.
template <class T>
[[nodiscard]] std::vector<T> coefficients_of(std::vector<T> brackets, const T& length,
                                             const T& pi) {
    using std::sqrt;
    const T unit = pi * sqrt(length);
    for (T& x : brackets) {
        x /= unit;
    }
    return brackets;
}
template <class T>
[[nodiscard]] std::vector<T> coefficients_of(std::vector<T> brackets, const T& length) {
    return coefficients_of(std::move(brackets), length, Field<T>::pi(length));
}

/// The law of the mirror image, whose right edge is the left edge of the contact: a(b + z), and
/// P'(a(b + z)) a'(b + z), with one term less. `law` has at least two terms.
template <class T> [[nodiscard]] LawSeries<T> mirrored(const LawSeries<T>& law, const T& a) {
    series::Series<T> shift = law.b;
    shift[0] = T(0);
    series::Series<T> edge = revert(shift); // a(b + z) - a
    const series::Series<T> rate = compose(law.force_rate, edge);
    const series::Series<T> rate_by_b = rate.truncated(edge.order() - 1) * derivative(edge);
    edge[0] = a;
    return {rate_by_b, edge};
}

} // namespace edgeproof::contact
