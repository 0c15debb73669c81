// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/quadrature/quadrature_value.hpp"
#include "edgeproof/quadrature/tanh_sinh_nodes.hpp"

#include <cstddef>
#include <optional>
#include <utility>

namespace edgeproof {

/// What a quadrature returns: never a value alone. `estimate` is the difference of the last two
/// levels relative to the integral of |f|. It is an estimate, not a bound: a narrow feature that
/// falls between the nodes is invisible to it, which is why callers split at every knot and apex.
template <class R> struct QuadratureResult {
    R value;
    typename QuadratureValue<R>::Scalar estimate;
    std::size_t evaluations = 0;
    bool converged = false;

    /// Takes in the integral over another interval.
    void add(const QuadratureResult& other) {
        value += other.value;
        evaluations += other.evaluations;
        converged = converged && other.converged;
        if (other.estimate > estimate) {
            estimate = other.estimate;
        }
    }
};

struct QuadratureOptions {
    int first_level = 3;
    int last_level = 14;
    /// Stop when two levels agree to so many digits of the integral of |f|; 0: to 100 units of
    /// roundoff.
    unsigned target_digits = 0;
    /// Stop, not converged, at a level from 7 on that is hardly nearer than the one two before. The
    /// digits of an integrand that is analytic but for its ends double from level to level; one
    /// that gains next to none has a kink inside or no finite integral, and no finer level settles
    /// it.
    bool gives_up = false;
};

/// Tanh-sinh quadrature (Takahasi & Mori 1974) of f over the unit interval, 50 digits or 500.
///
/// f is called as f(lo, hi) with lo + hi = 1, *both* distances exact to the last digit: near an
/// end point the small one is what the integrand must be written in. End-point singularities up
/// to d^(-1/2) (any logarithm times) cost no digits. R is T or Series<T>.
///
/// The working precision is that of the calling thread; node tables are per thread and precision.
/// Not converging by `last_level` is said in the result, never silent.
template <Arithmetic T, class F> auto tanh_sinh(const F& f, const QuadratureOptions& options = {}) {
    using std::pow;
    using R = std::remove_cvref_t<decltype(f(std::declval<const T&>(), std::declval<const T&>()))>;
    using V = QuadratureValue<R>;
    const TanhSinhNodes<T>& nodes = tanh_sinh_nodes<T>();
    const T tolerance = options.target_digits == 0 || options.target_digits + 2 >= digits_of<T>()
                            ? T(T(100) * unit_roundoff<T>())
                            : T(pow(T(10), -static_cast<int>(options.target_digits)));

    std::optional<R> sum;
    std::optional<R> magnitude;
    std::size_t evaluations = 0;
    const auto accumulate = [&](const T& weight, const R& value) {
        if (!sum) {
            sum = value * T(0);
            magnitude = value * T(0);
        }
        V::add(*sum, weight, value);
        V::add_magnitude(*magnitude, weight, value);
    };
    const auto evaluate = [&](const T& lo, const T& hi) {
        ++evaluations;
        R value = f(lo, hi);
        if (!V::finite(value)) {
            throw DomainError("an integrand is not finite inside its interval");
        }
        return value;
    };

    // A tail ends where its terms stay below roundoff three times running; finer levels then
    // need not look beyond that abscissa.
    const T negligible = tolerance / T(1 << 11);
    T end_lo = nodes.end();
    T end_hi = nodes.end();
    std::optional<R> previous;
    T before_last(0); // the estimate two levels ago, and
    T last(0);        // one level ago
    QuadratureResult<R> result{};
    for (int level = 0; level <= options.last_level; ++level) {
        const auto& table = nodes.level(level);
        for (const bool left : {true, false}) {
            int quiet = 0;
            T& end = left ? end_lo : end_hi;
            for (const auto& node : table) {
                if (node.t > end) {
                    break;
                }
                if (node.t == T(0)) {
                    if (left) {
                        accumulate(node.weight, evaluate(node.near, node.far));
                    }
                    continue;
                }
                const R value =
                    left ? evaluate(node.near, node.far) : evaluate(node.far, node.near);
                accumulate(node.weight, value);
                const bool small =
                    node.near < T(1) / T(8) &&
                    V::distance(value * node.weight, value * T(0), *magnitude) < negligible;
                quiet = small ? quiet + 1 : 0;
                if (quiet == 3 && level <= options.first_level) {
                    end = node.t;
                    break;
                }
            }
        }
        // Level h = 2^-level: the sums of all levels together are h times the new total.
        R estimate_now = *sum * T(nodes.step(level));
        if (level >= options.first_level && previous) {
            const R scale = *magnitude * T(nodes.step(level));
            result.estimate = V::distance(estimate_now, *previous, scale);
            if (result.estimate <= tolerance) {
                result.value = std::move(estimate_now);
                result.evaluations = evaluations;
                result.converged = true;
                return result;
            }
            if (options.gives_up && level >= 7 && result.estimate * T(30) > before_last) {
                break;
            }
            before_last = std::exchange(last, result.estimate);
        }
        previous = std::move(estimate_now);
    }
    result.value = std::move(*previous);
    result.evaluations = evaluations;
    return result;
}

} // namespace edgeproof
