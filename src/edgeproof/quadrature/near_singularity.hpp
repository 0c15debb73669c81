// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/real.hpp"
#include "edgeproof/quadrature/tanh_sinh.hpp"

#include <optional>
#include <utility>
#include <vector>

namespace edgeproof::quadrature {

/// The integral of f over an interval of length L, where f has a singularity *outside*, at the
/// distance `beyond` from one end (0: none known). A near one makes tanh-sinh slow
/// (`trefethen-weideman2014`). The map r = beyond (e^y - 1) moves it to y = -infinity, and a branch
/// cut beyond it to Im y = +-pi, for any distance. f is called with the distances from both ends,
/// both with all their digits. The result has the unit of f times that of `length`.
template <Arithmetic T, class R>
[[nodiscard]] QuadratureResult<R>
integrate_one_sided_of(const IntegrandRef<T, R>& f, const T& length, const T& beyond, bool at_lo,
                       const QuadratureOptions& options);
template <Arithmetic T, class F>
[[nodiscard]] auto integrate_one_sided(const F& f, const T& length, const T& beyond, bool at_lo,
                                       const QuadratureOptions& options = {}) {
    using R = IntegrandResult<T, F>;
    return integrate_one_sided_of<T, R>(IntegrandRef<T, R>(f), length, beyond, at_lo, options);
}

/// The same with singularities beyond both ends; the interval is halved if both are near.
template <Arithmetic T, class R>
[[nodiscard]] QuadratureResult<R> integrate_near_of(const IntegrandRef<T, R>& f, const T& length,
                                                    const T& beyond_lo, const T& beyond_hi,
                                                    const QuadratureOptions& options);
template <Arithmetic T, class F>
[[nodiscard]] auto integrate_near(const F& f, const T& length, const T& beyond_lo,
                                  const T& beyond_hi, const QuadratureOptions& options = {}) {
    using R = IntegrandResult<T, F>;
    return integrate_near_of<T, R>(IntegrandRef<T, R>(f), length, beyond_lo, beyond_hi, options);
}

/// The integral over consecutive intervals given by their lengths. The neighbouring cuts count as
/// singularities beyond an interval's ends; `beyond_first` and `beyond_last` are the distances for
/// the outermost ends (0: no singularity there). f is called as f(i, lo, hi) on interval i.
template <Arithmetic T, class F>
auto integrate_pieces(const F& f, const std::vector<T>& lengths, const T& beyond_first,
                      const T& beyond_last, const QuadratureOptions& options = {}) {
    using R = std::remove_cvref_t<decltype(f(std::size_t{}, lengths[0], lengths[0]))>;
    std::optional<QuadratureResult<R>> total;
    for (std::size_t i = 0; i < lengths.size(); ++i) {
        if (!(lengths[i] > T(0))) {
            continue;
        }
        auto part =
            integrate_near<T>([&](const T& lo, const T& hi) { return f(i, lo, hi); }, lengths[i],
                              i > 0 ? lengths[i - 1] : beyond_first,
                              i + 1 < lengths.size() ? lengths[i + 1] : beyond_last, options);
        if (!total) {
            total = std::move(part);
        } else {
            total->add(part);
        }
    }
    if (!total) {
        throw DomainError("an integral over an empty interval");
    }
    return std::move(*total);
}

} // namespace edgeproof::quadrature
