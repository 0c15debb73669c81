// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/quadrature/tanh_sinh.hpp"

#include "edgeproof/precision/bounded_cache.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/precision/real.hpp"

#include <deque>
#include <memory>
#include <utility>

namespace edgeproof::quadrature {
namespace {

constexpr std::size_t most_tables = 16; ///< the most tables of nodes that a thread keeps
constexpr int first_level = 3;          ///< the first level that may be the result

/// The abscissas and weights of tanh-sinh (`takahasi-mori1974`) on the unit interval at one
/// precision. Level k holds the nodes that are not in a lower level, from the middle outwards; it
/// is computed at its first use. An object belongs to one thread and one precision.
class Nodes {
public:
    struct Node {
        Real t;      ///< abscissa in the transformed variable, t >= 0
        Real near;   ///< distance from the nearer end point, with all its digits
        Real far;    ///< distance from the other end point
        Real weight; ///< d near/dt
    };

    Nodes()
        // The outermost node is so near the end that even an integrand like d^(-1/2) is negligible
        // beyond it.
        : end_(asinh(log(Real(10)) * (2 * working_digits() + 20) / pi<Real>())) {}

    [[nodiscard]] const Real& end() const noexcept { return end_; }
    [[nodiscard]] static Real step(int level) { return ldexp(Real(1), -level); }

    /// The nodes that are new in `level`.
    [[nodiscard]] const std::vector<Node>& level(int level) const {
        while (levels_.size() <= static_cast<std::size_t>(level)) {
            add_level();
        }
        return levels_[static_cast<std::size_t>(level)];
    }

private:
    void add_level() const {
        const int level = static_cast<int>(levels_.size());
        const Real h = step(level);
        std::vector<Node> nodes;
        const int stride = level == 0 ? 1 : 2;
        for (int j = level == 0 ? 0 : 1;; j += stride) {
            const Real t = h * j;
            if (t > end_) {
                break;
            }
            const Real e = exp(Real(pi<Real>() * sinh(t)));
            // near = (1 - tanh((pi/2) sinh t))/2 = 1/(1 + exp(pi sinh t)) (`takahasi-mori1974`)
            const Real sum = 1 + e;
            // d/dt 1/(1 + exp(pi sinh t)) = pi cosh t e/(1 + e)^2
            nodes.push_back({t, 1 / sum, e / sum, Real(pi<Real>() * cosh(t)) * e / sum / sum});
        }
        levels_.push_back(std::move(nodes));
    }

    Real end_;
    mutable std::deque<std::vector<Node>> levels_;
};

/// The nodes of this thread at its working precision.
std::shared_ptr<const Nodes> nodes_of_thread() {
    thread_local BoundedCache<unsigned, const Nodes> tables(most_tables);
    return tables.get(working_digits(), [] { return std::make_shared<const Nodes>(); });
}

/// |x - y| in units of `scale`.
Real distance(const Real& x, const Real& y, const Real& scale) {
    const Real d = abs(Real(x - y));
    return scale > 0 ? Real(d / scale) : d;
}

} // namespace

void QuadratureResult::add(const QuadratureResult& other) {
    value += other.value;
    evaluations += other.evaluations;
    converged = converged && other.converged;
    if (other.estimate > estimate) {
        estimate = other.estimate;
    }
}

QuadratureResult tanh_sinh(const Integrand& f, const QuadratureOptions& options) {
    const auto kept = nodes_of_thread();
    const Nodes& nodes = *kept;
    const Real tolerance =
        options.target_digits == 0 || options.target_digits + 2 >= working_digits()
            ? Real(100 * unit_roundoff<Real>())
            : Real(pow(Real(10), -static_cast<int>(options.target_digits)));

    QuadratureResult result;
    Real sum(0);
    Real magnitude(0);
    const auto accumulate = [&](const Real& weight, const Real& value) {
        sum += weight * value;
        magnitude += abs(Real(weight * value));
    };
    const auto evaluate = [&](const Real& lo, const Real& hi) {
        ++result.evaluations;
        check_interruption();
        Real value = f(lo, hi);
        if (!isfinite(value)) {
            throw DomainError("an integrand is not finite inside its interval");
        }
        return value;
    };

    // A tail ends after three successive terms below roundoff; higher levels do not go beyond this
    // abscissa.
    const Real negligible = tolerance / (1 << 11);
    Real end_lo = nodes.end();
    Real end_hi = nodes.end();
    for (int level = 0; level <= options.last_level; ++level) {
        const auto& table = nodes.level(level);
        for (const bool left : {true, false}) {
            int quiet = 0;
            Real& end = left ? end_lo : end_hi;
            for (const auto& node : table) {
                if (node.t > end) {
                    break;
                }
                if (node.t == 0) {
                    if (left) {
                        accumulate(node.weight, evaluate(node.near, node.far));
                    }
                    continue;
                }
                const Real value =
                    left ? evaluate(node.near, node.far) : evaluate(node.far, node.near);
                accumulate(node.weight, value);
                const bool small = node.near < Real(1) / 8 &&
                                   distance(value * node.weight, Real(0), magnitude) < negligible;
                quiet = small ? quiet + 1 : 0;
                if (quiet == 3 && level <= first_level) {
                    end = node.t;
                    break;
                }
            }
        }
        // The step of a level is h = 2^-level: the integral is h times the sum over all levels
        // (`takahasi-mori1974`).
        const Real before = std::exchange(result.value, sum * Nodes::step(level));
        if (level >= first_level) {
            result.estimate = distance(result.value, before, magnitude * Nodes::step(level));
            result.converged = result.estimate <= tolerance;
            if (result.converged) {
                break;
            }
        }
    }
    return result;
}

namespace {

/// A singularity beyond one end. The map r = beyond (e^y - 1) moves it to y = -infinity, and a
/// branch cut beyond it to Im y = +-pi, for any distance.
QuadratureResult integrate_one_sided(const Integrand& f, const Real& length, const Real& beyond,
                                     bool at_lo, const QuadratureOptions& options) {
    QuadratureResult result;
    if (beyond > 0 && beyond < length / 8) {
        const Real y_end = log1p(Real(length / beyond));
        const Real whole = length + beyond;
        const Real half = Real(1) / 2;
        result = tanh_sinh(
            [&](const Real& lo, const Real& hi) {
                const Real& y = at_lo ? lo : hi;
                const Real& y_rest = at_lo ? hi : lo;
                // The double exponential rule (takahasi-mori1974) in y with
                // r = beyond (e^(y_end y) - 1), rest = whole (1 - e^(-y_end y_rest)), and
                // dr = y_end (r + beyond) dy. The larger of r and rest is the length less the
                // other, so that only one exponential is needed.
                const Real to_go = y_end * y_rest;
                Real r;
                Real rest;
                if (to_go < half) {
                    rest = -whole * expm1(Real(-to_go));
                    r = length - rest;
                } else {
                    r = beyond * expm1(Real(y_end * y));
                    rest = length - r;
                }
                return Real((at_lo ? f(r, rest) : f(rest, r)) * Real(r + beyond));
            },
            options);
        result.value = result.value * y_end;
        return result;
    }
    result = tanh_sinh(
        [&](const Real& lo, const Real& hi) { return f(Real(length * lo), Real(length * hi)); },
        options);
    result.value = result.value * length;
    return result;
}

} // namespace

QuadratureResult integrate_near(const Integrand& f, const Real& length, const Real& beyond_lo,
                                const Real& beyond_hi, const QuadratureOptions& options) {
    const Real close = length / 8;
    const bool near_lo = beyond_lo > 0 && beyond_lo < close;
    const bool near_hi = beyond_hi > 0 && beyond_hi < close;
    if (!(near_lo && near_hi)) {
        return integrate_one_sided(f, length, near_hi ? beyond_hi : beyond_lo, !near_hi, options);
    }
    const Real half = length / 2;
    QuadratureResult sum =
        integrate_one_sided([&](const Real& lo, const Real& hi) { return f(lo, Real(half + hi)); },
                            half, beyond_lo, true, options);
    sum.add(
        integrate_one_sided([&](const Real& lo, const Real& hi) { return f(Real(half + lo), hi); },
                            half, beyond_hi, false, options));
    return sum;
}

QuadratureResult
integrate_pieces(const std::function<Real(std::size_t, const Real& lo, const Real& hi)>& f,
                 const std::vector<Real>& lengths, const Real& beyond_first,
                 const Real& beyond_last, const QuadratureOptions& options) {
    QuadratureResult total{Real(0), Real(0), 0, true};
    for (std::size_t i = 0; i < lengths.size(); ++i) {
        if (lengths[i] > 0) {
            total.add(integrate_near([&](const Real& lo, const Real& hi) { return f(i, lo, hi); },
                                     lengths[i], i > 0 ? lengths[i - 1] : beyond_first,
                                     i + 1 < lengths.size() ? lengths[i + 1] : beyond_last,
                                     options));
        }
    }
    return total.evaluations > 0 ? total : throw DomainError("an integral over an empty interval");
}

} // namespace edgeproof::quadrature
