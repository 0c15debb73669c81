// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/scene/route/omitted_terms.hpp"

#include "edgeproof/precision/ball/magnitude.hpp"

#include <algorithm>

namespace edgeproof::scene {

Ball omitted_terms(const BoundedSeries& series, std::size_t n, const Ball& u) {
    const long bits = u.bits();
    const Ball part = u / series.radius;
    const Ball limit(Rational(1, 16), bits);
    if (!series.most.is_finite() || !part.is_finite() || !certainly_less(abs(part), limit)) {
        Ball unknown(0, bits);
        arb_indeterminate(unknown.data());
        return unknown;
    }
    // Each term is at most a 16th of the term before.
    const std::size_t smallness = static_cast<std::size_t>(
        std::max<slong>(4, -arf_abs_bound_lt_2exp_si(arb_midref(part.data()))));
    const std::size_t count = n + static_cast<std::size_t>(bits) / smallness + 2;
    const std::vector<Ball> c = series.coefficients(count);
    Ball sum =
        Magnitude(series.most * pow_int(part, static_cast<long>(count)) / (1 - part)).ball(bits);
    for (std::size_t k = count; k-- > n;) {
        sum += c[k] * pow_int(u, static_cast<long>(k));
    }
    return sum;
}

} // namespace edgeproof::scene
