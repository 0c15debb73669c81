// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/series/truncated.hpp"

namespace edgeproof::series {

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

} // namespace edgeproof::series
