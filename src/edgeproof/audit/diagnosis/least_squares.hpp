// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <optional>
#include <vector>

namespace edgeproof::audit {

/// Solves (J^T J + damping) x = J^T r by Gauss-Jordan elimination, with the largest pivot on the
/// diagonal first. It ends at a pivot that is not above `least_pivot`: the unknowns that are left,
/// which the rows of J do not distinguish, get no value. Without a bound of the roundoff.
template <class T>
[[nodiscard]] std::vector<std::optional<T>> least_squares(const std::vector<std::vector<T>>& J,
                                                          const std::vector<T>& r, const T& damping,
                                                          const T& least_pivot) {
    const std::size_t n = J.front().size();
    std::vector<std::vector<T>> m(n, std::vector<T>(n + 1, T(0)));
    for (std::size_t k = 0; k < J.size(); ++k) {
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t j = 0; j < n; ++j) {
                m[i][j] += J[k][i] * J[k][j];
            }
            m[i][n] += J[k][i] * r[k];
        }
    }
    std::vector<bool> used(n, false);
    for (std::size_t i = 0; i < n; ++i) {
        m[i][i] += damping;
    }
    for (std::size_t step = 0; step < n; ++step) {
        std::size_t best = n;
        for (std::size_t i = 0; i < n; ++i) {
            if (!used[i] && (best == n || m[i][i] > m[best][best])) {
                best = i;
            }
        }
        if (!(m[best][best] > least_pivot)) {
            break;
        }
        used[best] = true;
        for (std::size_t i = 0; i < n; ++i) {
            if (i == best) {
                continue;
            }
            const T f = m[i][best] / m[best][best];
            for (std::size_t j = 0; j <= n; ++j) {
                m[i][j] -= f * m[best][j];
            }
        }
    }
    std::vector<std::optional<T>> x(n);
    for (std::size_t i = 0; i < n; ++i) {
        if (used[i]) {
            x[i] = T(m[i][n] / m[i][i]);
        }
    }
    return x;
}

} // namespace edgeproof::audit
