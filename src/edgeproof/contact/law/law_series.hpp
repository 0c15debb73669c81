// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/law/kernels.hpp"

#include <algorithm>
#include <cstddef>

namespace edgeproof::contact {

/// b(a + z) as a power series of type S by Newton's method on the consistency condition
/// (docs/expansions.md, "The series of the law: the consistency condition"). Each step doubles the
/// number of correct terms. `a` is the series a + z, `b` its left edge at z = 0 (lengths).
/// `imbalance(e)` is the right side less the left side of the condition for edges that are series;
/// `left_rate(e)` is the integral of sqrt((a-v)/(v+b)) dg', so that
/// -left_rate/(a + b) is the derivative of the imbalance with respect to b.
template <class S, class T, class Imbalance, class Rate>
[[nodiscard]] S left_edge_by_newton(const S& a, const T& b, const Imbalance& imbalance,
                                    const Rate& left_rate) {
    using F = Field<S>;
    S series(b, 1);
    for (std::size_t known = 1; known < a.order();) {
        known = std::min(2 * known, a.order());
        const Extent<S> trial{F::resized(a, known), F::resized(series, known)};
        S gap = imbalance(trial);
        F::set_constant(gap, Field<T>::number(0, b)); // the condition holds at z = 0
        // Newton's step: b - C/C_b with C_b = -left_rate/(a + b)
        series = trial.b + gap / (left_rate(trial) / trial.length());
        F::set_constant(series, b);
    }
    return series;
}

} // namespace edgeproof::contact
