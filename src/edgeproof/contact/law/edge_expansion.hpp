// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/contact/law/field.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/series/truncated.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace edgeproof::contact {

/// P'(a + z) and b(a + z) as truncated series in z, the input of an edge expansion. S is
/// series::Series or BallSeries. Units of the coefficients of z^k: force per unit length over
/// length^(k+1), and length^(1-k).
template <class S> struct LawSeries {
    S force_rate; ///< dP/da, the total derivative along the family of contacts
    S b;          ///< b(a + z); a + z itself for a symmetric contact
};

/// The brackets r_k of the coefficients c_k = r_k/(pi sqrt(a + b)) at the right edge, over any
/// field T, symbols included (docs/expansions.md, "The right edge"). With s = a - u sigma in
/// moore-hills EQ21 (first branch), p(a - u) is sqrt(u)/(pi sqrt(D)) times the integral over
/// 0 < sigma < 1 of
/// P'(a - u sigma) (1 - sigma)^(-1/2) [(x + b(s))/D]^(-1/2), D = a + b.
/// With w = u sigma, (x + b(s))/D = g(w) - u/D, g(w) = (a + b(a - w))/D, so that the root is the
/// sum over m of binomial(-1/2, m) (-u/D)^m g(w)^(-1/2 - m): one series in w for each m.
/// `law` holds P'(a + z) and b(a + z); the result has as many brackets as these series have terms.
template <class S, class T>
[[nodiscard]] std::vector<T> right_edge_brackets(const LawSeries<S>& law, const T& a) {
    const auto n = static_cast<int>(std::min(law.force_rate.order(), law.b.order()));
    const auto nth = [](int k) { return static_cast<std::size_t>(k); };
    const T D = a + law.b[0];
    const T one = Field<T>::number(1, D);
    std::vector<T> g{one};
    std::vector<T> rate; // P'(a - w)
    std::vector<T>
        beta; // the integral of sigma^j (1 - sigma)^(-1/2) is B(j + 1, 1/2) (DLMF 5.12.1)
    for (int k = 0; k < n; ++k) {
        const int sign = k % 2 == 0 ? 1 : -1;
        rate.push_back(T(law.force_rate[nth(k)] * sign));
        if (k > 0) {
            g.push_back(T(law.b[nth(k)] / D * sign));
        }
        beta.push_back(k == 0 ? T(one * 2) : T(beta.back() * (2 * k) / (2 * k + 1)));
    }
    const S inverse = S(one, nth(n)) / S(g);
    S power = S(rate) * Field<S>::inverse_root(S(g)); // P'(a - w) g(w)^(-1/2 - m)
    std::vector<T> brackets(nth(n), Field<T>::number(0, D));
    T factor = one; // binomial(-1/2, m) (-1/D)^m
    for (int m = 0; m < n; ++m) {
        check_interruption();
        for (int l = 0; m + l < n; ++l) {
            brackets[nth(m + l)] += factor * power[nth(l)] * beta[nth(l)];
        }
        if (m + 1 < n) {
            power = Field<S>::resized(power, nth(n - m - 1)) * inverse;
        }
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
template <class S, class T>
[[nodiscard]] LawSeries<S> mirrored(const LawSeries<S>& law, const T& a) {
    S shift = law.b;
    shift[0] = T(0);
    S edge = revert(shift); // a(b + z) - a
    const S rate = compose(law.force_rate, edge);
    const S rate_by_b = rate.truncated(edge.order() - 1) * derivative(edge);
    edge[0] = a;
    return {rate_by_b, edge};
}

} // namespace edgeproof::contact
