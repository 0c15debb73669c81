// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/quadrature/tanh_sinh.hpp"

#include "edgeproof/precision/arithmetic.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/quadrature/tanh_sinh_nodes.hpp"

#include <cmath>
#include <optional>
#include <utility>

namespace edgeproof::quadrature {

namespace {

/// The predicted error of a level (growth_of_level): `difference` is that from the level before,
/// `last` the difference before.
template <Arithmetic T> T foreseen(const T& difference, const T& last) {
    using std::log;
    using std::pow;
    if (!(difference > T(0)) || !(difference < last) || !(last < T(1) / T(8))) {
        return difference;
    }
    const auto d1 = static_cast<double>(log(difference));
    const auto d2 = static_cast<double>(log(last));
    return pow(difference, T(growth_of_level(d1, d2)));
}

} // namespace

template <Arithmetic T, class R>
QuadratureResult<R> tanh_sinh_of(const IntegrandRef<T, R>& f, const QuadratureOptions& options) {
    using std::pow;
    using V = QuadratureValue<R>;
    const auto kept = tanh_sinh_nodes<T>();
    const TanhSinhNodes<T>& nodes = *kept;
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
        check_interruption();
        R value = f(lo, hi);
        if (!V::finite(value)) {
            throw DomainError("an integrand is not finite inside its interval");
        }
        return value;
    };

    // A tail ends after three successive terms below roundoff; higher levels do not go beyond this
    // abscissa.
    const T negligible = tolerance / T(1 << 11);
    T end_lo = nodes.end();
    T end_hi = nodes.end();
    std::optional<R> previous;
    T before_last(0); // the difference two levels ago
    T last(0);        // the difference one level ago
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
        // The step of a level is h = 2^-level: the integral is h times the sum over all levels
        // (`takahasi-mori1974`).
        R estimate_now = *sum * T(nodes.step(level));
        if (level >= options.first_level && previous) {
            const R scale = *magnitude * T(nodes.step(level));
            const T difference = V::distance(estimate_now, *previous, scale);
            result.estimate = options.foresees ? foreseen<T>(difference, last) : difference;
            if (result.estimate <= tolerance) {
                result.value = std::move(estimate_now);
                result.evaluations = evaluations;
                result.converged = true;
                return result;
            }
            // Only far from convergence: near the end roundoff may be the reason.
            if (options.gives_up && level >= 8 && result.estimate > T(1) / T(1 << 16) &&
                difference * T(8) > before_last) {
                previous = std::move(estimate_now);
                break;
            }
            before_last = std::exchange(last, difference);
        }
        previous = std::move(estimate_now);
    }
    result.value = std::move(*previous);
    result.evaluations = evaluations;
    return result;
}

// NOLINTBEGIN(bugprone-macro-parentheses): a type, not a value
#define EDGEPROOF_INSTANTIATE(T)                                                                   \
    template QuadratureResult<T> tanh_sinh_of(const IntegrandRef<T, T>&, const QuadratureOptions&);
// NOLINTEND(bugprone-macro-parentheses)
EDGEPROOF_FOR_EACH_ARITHMETIC(EDGEPROOF_INSTANTIATE)
#undef EDGEPROOF_INSTANTIATE

} // namespace edgeproof::quadrature
