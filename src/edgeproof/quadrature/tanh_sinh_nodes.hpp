// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/arithmetic.hpp"
#include "edgeproof/precision/bounded_cache.hpp"
#include "edgeproof/precision/real.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <memory>
#include <vector>

namespace edgeproof::quadrature {

/// The abscissas and weights of tanh-sinh (`takahasi-mori1974`) on the unit interval at one
/// precision. Level k holds the nodes that are not in a lower level, from the middle outwards; it
/// is computed at its first use. An object belongs to one thread and one precision
/// (`tanh_sinh_nodes<T>()` returns it).
template <Arithmetic T> class TanhSinhNodes {
public:
    struct Node {
        T t;      ///< abscissa in the transformed variable, t >= 0
        T near;   ///< distance from the nearer end point, with all its digits
        T far;    ///< distance from the other end point
        T weight; ///< d near/dt
    };

    TanhSinhNodes() : end_(T(0)) {
        using std::asinh;
        using std::log;
        // The outermost node is so near the end that even an integrand like d^(-1/2) is negligible
        // beyond it.
        const T depth = log(T(10)) * T(static_cast<int>(smallest_exponent()));
        end_ = asinh(depth / pi<T>());
    }

    [[nodiscard]] const T& end() const noexcept { return end_; }
    [[nodiscard]] static T step(int level) {
        T h(1);
        for (int k = 0; k < level; ++k) {
            h /= 2;
        }
        return h;
    }

    /// The nodes that are new in `level`.
    [[nodiscard]] const std::vector<Node>& level(int level) const {
        while (levels_.size() <= static_cast<std::size_t>(level)) {
            add_level();
        }
        return levels_[static_cast<std::size_t>(level)];
    }

private:
    static unsigned smallest_exponent() {
        return std::same_as<T, double> ? 300 : 2 * digits_of<T>() + 20;
    }
    void add_level() const {
        using std::cosh;
        using std::exp;
        using std::sinh;
        const int level = static_cast<int>(levels_.size());
        const T h = step(level);
        std::vector<Node> nodes;
        const int stride = level == 0 ? 1 : 2;
        for (int j = level == 0 ? 0 : 1;; j += stride) {
            const T t = h * T(j);
            if (t > end_) {
                break;
            }
            const T e = exp(T(pi<T>() * sinh(t)));
            // near = (1 - tanh((pi/2) sinh t))/2 = 1/(1 + exp(pi sinh t)) (`takahasi-mori1974`)
            const T sum = T(1) + e;
            // d/dt 1/(1 + exp(pi sinh t)) = pi cosh t e/(1 + e)^2
            nodes.push_back({t, T(1) / sum, e / sum, T(pi<T>() * cosh(t)) * e / sum / sum});
        }
        levels_.push_back(std::move(nodes));
    }

    T end_;
    mutable std::deque<std::vector<Node>> levels_;
};

constexpr std::size_t most_tanh_sinh_tables = 16; ///< the most tables that a thread keeps

/// The node tables of this thread at its working precision.
template <Arithmetic T> [[nodiscard]] std::shared_ptr<const TanhSinhNodes<T>> tanh_sinh_nodes() {
    thread_local BoundedCache<unsigned, const TanhSinhNodes<T>> tables(most_tanh_sinh_tables);
    return tables.get(digits_of<T>(), [] { return std::make_shared<const TanhSinhNodes<T>>(); });
}

/// ln |x| in binary64, for any size of x; -1e300 for 0.
[[nodiscard]] inline double ln_size(const Real& x) {
    if (x == 0) {
        return -1e300;
    }
    long exponent = 0;
    const double mantissa = mpfr_get_d_2exp(&exponent, x.backend().data(), MPFR_RNDN);
    return std::log(std::abs(mantissa)) + 0.6931471805599453 * static_cast<double>(exponent);
}

/// exp(ln) to the digits of binary64, for any ln; accurate enough for an estimate.
[[nodiscard]] inline Real from_ln_size(double ln) {
    ln = std::clamp(ln, -1e15, 1e15);
    const double exponent = std::floor(ln / 0.6931471805599453);
    Real x;
    mpfr_set_d(x.backend().data(), std::exp(ln - 0.6931471805599453 * exponent), MPFR_RNDN);
    mpfr_mul_2si(x.backend().data(), x.backend().data(), static_cast<long>(exponent), MPFR_RNDN);
    return x;
}

/// The assumed ratio of the digits of a level to those that it shares with the level before
/// (`bailey-jeyabalan-li2005`). exp(d1) is the relative difference of these two levels, exp(d2)
/// that of the two levels before; d1 < d2 < 0. For a rule that converges quadratically the digits
/// grow as d1^2/d2, that is, they double; a growth by at most the factor 1.4 is assumed, since an
/// integrand with two scales converges more slowly at first. This is an estimate.
[[nodiscard]] inline double growth_of_level(double d1, double d2) { return std::min(d1 / d2, 1.4); }

} // namespace edgeproof::quadrature
