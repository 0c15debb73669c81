// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/quadrature/near_singularity.hpp"
#include "edgeproof/precision/arithmetic.hpp"
#include "edgeproof/precision/bounded_cache.hpp"
#include "edgeproof/precision/elementary/elementary.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/quadrature/gauss_legendre.hpp"
#include "edgeproof/quadrature/tanh_sinh_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace edgeproof::quadrature {

template <Arithmetic T, class R>
QuadratureResult<R> integrate_one_sided_of(const IntegrandRef<T, R>& f, const T& length,
                                           const T& beyond, bool at_lo,
                                           const QuadratureOptions& options) {
    using std::log1p;
    if (beyond > T(0) && beyond < length / T(8)) {
        const T y_end = log1p(T(length / beyond));
        const T whole = length + beyond;
        const T half = T(1) / T(2);
        auto result = tanh_sinh<T>(
            [&](const T& lo, const T& hi) {
                const T& y = at_lo ? lo : hi;
                const T& y_rest = at_lo ? hi : lo;
                // The double exponential rule (takahasi-mori1974) in y with
                // r = beyond (e^(y_end y) - 1), rest = whole (1 - e^(-y_end y_rest)), and
                // dr = y_end (r + beyond) dy. The larger of r and rest is the length less the
                // other, so that only one exponential is needed.
                const T to_go = y_end * y_rest;
                T r;
                T rest;
                if (to_go < half) {
                    rest = -whole * exp_less_one(T(-to_go));
                    r = length - rest;
                } else {
                    r = beyond * exp_less_one(T(y_end * y));
                    rest = length - r;
                }
                return R((at_lo ? f(r, rest) : f(rest, r)) * T(r + beyond));
            },
            options);
        result.value = result.value * y_end;
        return result;
    }
    auto result = tanh_sinh<T>(
        [&](const T& lo, const T& hi) { return f(T(length * lo), T(length * hi)); }, options);
    result.value = result.value * length;
    return result;
}

template <Arithmetic T, class R>
QuadratureResult<R> integrate_near_of(const IntegrandRef<T, R>& f, const T& length,
                                      const T& beyond_lo, const T& beyond_hi,
                                      const QuadratureOptions& options) {
    const T close = length / T(8);
    const bool near_lo = beyond_lo > T(0) && beyond_lo < close;
    const bool near_hi = beyond_hi > T(0) && beyond_hi < close;
    if (!(near_lo && near_hi)) {
        return integrate_one_sided_of<T, R>(f, length, near_hi ? beyond_hi : beyond_lo, !near_hi,
                                            options);
    }
    const T half = length / T(2);
    auto left =
        integrate_one_sided<T>([&](const T& lo, const T& hi) { return f(lo, T(half + hi)); }, half,
                               beyond_lo, true, options);
    const auto right =
        integrate_one_sided<T>([&](const T& lo, const T& hi) { return f(T(half + lo), hi); }, half,
                               beyond_hi, false, options);
    left.add(right);
    return left;
}

#define EDGEPROOF_INSTANTIATE_FOR(T, R)                                                            \
    template QuadratureResult<R> integrate_one_sided_of(const IntegrandRef<T, R>&, const T&,       \
                                                        const T&, bool, const QuadratureOptions&); \
    template QuadratureResult<R> integrate_near_of(const IntegrandRef<T, R>&, const T&, const T&,  \
                                                   const T&, const QuadratureOptions&);
#define EDGEPROOF_INSTANTIATE(T)                                                                   \
    EDGEPROOF_INSTANTIATE_FOR(T, T)                                                                \
    EDGEPROOF_INSTANTIATE_FOR(T, series::Series<T>)
EDGEPROOF_FOR_EACH_ARITHMETIC(EDGEPROOF_INSTANTIATE)
#undef EDGEPROOF_INSTANTIATE
#undef EDGEPROOF_INSTANTIATE_FOR

namespace {

using At = IntegrandRef<Real, Real>;

constexpr double node_ratio = 1.5;
/// The least factor by which the digits must grow for 1.5 times the nodes in the first rules, which
/// show whether the digits grow like the nodes.
constexpr double growth_asked = 1.25;
/// The last rule has this many times the nodes of the rule that it is compared with, and no further
/// digits are predicted. A singularity with a small factor shows only where the error has fallen to
/// its size, and may lie below the digits that two rules share.
constexpr double last_ratio = 1.2;
/// The part of the expected growth of the digits that is assumed.
constexpr double counted_on = 0.9;
constexpr double most_per_digit = 6; ///< nodes for each digit at which the search ends
/// The search also ends if a rule has less than this part of the digits expected for its nodes.
constexpr double still_growing = 0.75;
constexpr double ln_10 = 2.302585092994046;

/// A node of a Gauss-Legendre rule over 0 < v < 1, with its values under the maps.
struct MappedNode {
    Real sine;     ///< sin(pi v/2)
    Real rest;     ///< 1 - sin(pi v/2)
    Real sine_2;   ///< sin^2(pi v/2)
    Real cosine_2; ///< cos^2(pi v/2)
    Real weight;   ///< weight times (pi/2) cos(pi v/2), for an integral over the sine
    Real weight_2; ///< weight times pi sin(pi v/2) cos(pi v/2), for an integral over its square
};

using MappedNodes = std::vector<MappedNode>;
constexpr std::size_t most_mapped_rules = 64; ///< the most rules that a thread keeps

MappedNodes mapped(std::size_t n) {
    const auto rule =
        gauss_legendre_rule(n, static_cast<long>(Real().backend().data()->_mpfr_prec));
    const Real quarter = pi<Real>() / 4;
    MappedNodes nodes;
    nodes.reserve(n);
    // The sine of the smaller angle gives both squares with all their digits.
    const auto add = [&](std::size_t k, bool upper) {
        const Real angle = rule.from_end[k] * quarter / 2; // half of pi (1 - v)/2, or of pi v/2
        const Real small = sin(angle);
        const Real near = 2 * small * cos(angle); // the sine of the smaller angle
        const Real far = 1 - 2 * small * small;   // its cosine
        MappedNode node;
        node.sine = upper ? far : near;
        node.rest = upper ? Real(2 * small * small) : Real(1 - near);
        node.sine_2 = node.sine * node.sine;
        node.cosine_2 = upper ? Real(near * near) : Real(far * far);
        const Real w = rule.weight[k] * quarter;
        node.weight = w * (upper ? near : far);
        node.weight_2 = 2 * w * near * far;
        nodes.push_back(std::move(node));
    };
    for (std::size_t k = 0; k < rule.x.size(); ++k) {
        add(k, true);
        if (rule.x[k] != 0) {
            add(k, false);
        }
    }
    return nodes;
}

/// The mapped rule of n nodes, kept for each thread: its cost is small compared with that of the
/// integrands.
std::shared_ptr<const MappedNodes> mapped_nodes(std::size_t n) {
    thread_local BoundedCache<std::pair<std::size_t, unsigned>, const MappedNodes> known(
        most_mapped_rules);
    return known.get({n, working_digits()},
                     [&] { return std::make_shared<const MappedNodes>(mapped(n)); });
}

/// The sum of a rule, and the sum of the magnitudes of its terms.
struct Sum {
    Real value{0};
    Real magnitude{0};
    void add(const Real& term) {
        check_interruption();
        if (!isfinite(term)) {
            throw DomainError("an integrand is not finite inside its interval");
        }
        value += term;
        magnitude += abs(term);
    }
};

/// The integral with roots at both ends and none near beyond them: r = length sin^2(pi v/2).
Sum between_ends(const At& f, const Real& length, std::size_t n) {
    Sum sum;
    const auto nodes = mapped_nodes(n);
    for (const MappedNode& node : *nodes) {
        // dr = length pi sin(pi v/2) cos(pi v/2) dv
        sum.add(node.weight_2 * f(Real(length * node.sine_2), Real(length * node.cosine_2)));
    }
    sum.value *= length;
    sum.magnitude *= length;
    return sum;
}

/// The integral with a root at the distance `beyond` before the end r = 0: r = beyond sinh^2 w
/// removes this root and that at r = 0, and w = w_end sin(pi v/2) the root at the other end. f is
/// called with r and the rest of the length.
template <class F>
Sum sum_near_root(const F& f, const Real& length, const Real& beyond, std::size_t n) {
    const Real w_end = asinh(sqrt(Real(length / beyond)));
    Sum sum;
    const auto nodes = mapped_nodes(n);
    for (const MappedNode& node : *nodes) {
        const Real w = w_end * node.sine;
        const Real to_go = w_end * node.rest;
        const Real s = hyperbolic_sine(w);
        const Real s_2 = s * s;
        const Real r = beyond * s_2;
        const Real rest =
            to_go < w ? Real(beyond * hyperbolic_sine(to_go) * hyperbolic_sine(Real(w_end + w)))
                      : Real(length - r);
        const Real both = 2 * s * sqrt(Real(1 + s_2)); // sinh 2w, from dr = beyond sinh 2w dw
        sum.add(node.weight * both * f(r, rest));
    }
    sum.value *= beyond * w_end;
    sum.magnitude *= beyond * w_end;
    return sum;
}

/// The rule of n nodes over the interval of a map, or over each half if there are near roots beyond
/// both ends.
class Mapped {
public:
    Mapped(const At& f, const Real& length, const Real& beyond_lo, const Real& beyond_hi)
        : f_(f), length_(length), beyond_lo_(beyond_lo), beyond_hi_(beyond_hi) {
        const Real close = length / 8;
        near_lo_ = beyond_lo > 0 && beyond_lo < close;
        near_hi_ = beyond_hi > 0 && beyond_hi < close;
    }
    [[nodiscard]] Sum operator()(std::size_t n) const {
        if (near_lo_ && near_hi_) {
            const Real half = length_ / 2;
            Sum sum = sum_near_root(
                [&](const Real& r, const Real& rest) { return f_(r, Real(half + rest)); }, half,
                beyond_lo_, n);
            const Sum right = sum_near_root(
                [&](const Real& r, const Real& rest) { return f_(Real(half + rest), r); }, half,
                beyond_hi_, n);
            sum.value += right.value;
            sum.magnitude += right.magnitude;
            return sum;
        }
        if (near_lo_) {
            return sum_near_root(f_, length_, beyond_lo_, n);
        }
        if (near_hi_) {
            return sum_near_root([&](const Real& r, const Real& rest) { return f_(rest, r); },
                                 length_, beyond_hi_, n);
        }
        return between_ends(f_, length_, n);
    }
    [[nodiscard]] std::size_t evaluations(std::size_t n) const {
        return near_lo_ && near_hi_ ? 2 * n : n;
    }

private:
    const At& f_;
    const Real& length_;
    const Real& beyond_lo_;
    const Real& beyond_hi_;
    bool near_lo_ = false;
    bool near_hi_ = false;
};

} // namespace

std::optional<QuadratureResult<Real>> integrate_root_ends(const IntegrandRef<Real, Real>& f,
                                                          const Real& length, const Real& beyond_lo,
                                                          const Real& beyond_hi) {
    const double target = working_digits() - 2.0;
    const Mapped rule(f, length, beyond_lo, beyond_hi);
    std::size_t evaluations = 0;
    std::optional<Sum> last;
    double last_n = 0;
    // The number of digits that the next sum shares with the last one.
    const auto next = [&](double n) {
        const auto nodes = static_cast<std::size_t>(n);
        Sum sum = rule(nodes);
        evaluations += rule.evaluations(nodes);
        double digits = 0;
        if (last) {
            const double ln = ln_size(Real(sum.value - last->value)) - ln_size(sum.magnitude);
            digits = std::min(-ln / ln_10, 1e6);
        }
        last = std::move(sum);
        last_n = n;
        return digits;
    };
    const auto result = [&](double digits) {
        return QuadratureResult<Real>{last->value, from_ln_size(-std::min(digits, target) * ln_10),
                                      evaluations, true};
    };
    // Three small rules show whether the digits grow like the nodes.
    double n = std::max(10.0, target / 8);
    (void)next(n);
    const double first = next(n * node_ratio);
    const double second = next(n * node_ratio * node_ratio);
    if (second >= target) {
        return result(second);
    }
    if (second < 3 || second < growth_asked * first) {
        return std::nullopt;
    }
    // Then one rule that is expected to have nearly all digits, and one with all digits; the sizes
    // are always the same, so that few tables of nodes are made.
    const double per_node = second / (n * node_ratio);
    n *= node_ratio * node_ratio;
    double m = n * last_ratio;
    while (m * last_ratio < target / per_node) {
        m *= last_ratio;
    }
    double shared = next(m);
    while (last_n < most_per_digit * target && shared > still_growing * per_node * n) {
        n = last_n;
        shared = next(n * last_ratio);
        if (shared * (1 + (last_ratio - 1) * counted_on) >= target) {
            return result(shared * (1 + (last_ratio - 1) * counted_on));
        }
    }
    return std::nullopt;
}

} // namespace edgeproof::quadrature
