// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/law/kernels.hpp"

#include <algorithm>
#include <cstddef>

namespace edgeproof::contact {

/// b(a + z) as a power series by Newton's method on the balance of the edges, for a series type S
/// of any field: each step doubles the terms that are right. `imbalance(e)` is the right side less
/// the left for edges that move, `left_rate(e)` the integral of sqrt((a-v)/(v+b)) dg', so that
/// -left_rate/(a + b) is the imbalance's derivative by b. `b` is where the left edge is put.
template <class S, class T, class Imbalance, class Rate>
[[nodiscard]] S left_edge_by_newton(const S& a, const T& b, const Imbalance& imbalance,
                                    const Rate& left_rate) {
    using F = Field<S>;
    S series(b, 1);
    for (std::size_t known = 1; known < a.order();) {
        known = std::min(2 * known, a.order());
        const Extent<S> trial{F::resized(a, known), F::resized(series, known)};
        S gap = imbalance(trial);
        F::set_constant(gap, Field<T>::number(0, b)); // the edges balance
        series = trial.b + gap / (left_rate(trial) / trial.length());
        F::set_constant(series, b);
    }
    return series;
}

} // namespace edgeproof::contact
