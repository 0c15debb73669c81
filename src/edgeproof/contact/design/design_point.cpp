// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/design/best_reach.hpp"
#include "edgeproof/contact/enclosure/ball_values.hpp"
#include "edgeproof/precision/interruption.hpp"

#include <array>
#include <utility>

namespace edgeproof::contact {
namespace {

constexpr int most_newton_steps_of_a_point = 40;
constexpr int most_inflations_of_a_point = 14;

/// Two equations in (u, parameter) and their derivatives.
struct EquationValues {
    std::array<Ball, 2> f;
    std::array<Ball, 4>
        rates; ///< derivatives of f[0] by u and by the parameter, then those of f[1]
};

EquationValues equations_at(const ReachProblem& problem, const DesignEquations& of, const Ball& u,
                            const Ball& parameter) {
    const long bits = u.bits();
    const Ball level(problem.tolerance, bits);
    const auto errors = problem.over(parameter);
    const Jet f = errors[of.edge].jet(u);
    EquationValues e;
    e.f[0] = f.v - level * of.side;
    e.rates[0] = f.g[0];
    e.rates[1] = f.g[1];
    if (of.kind == BestReach::Kind::two_edges) {
        const Jet other = errors[1 - of.edge].jet(u);
        e.f[1] = other.v - level * of.other_side;
        e.rates[2] = other.g[0];
        e.rates[3] = other.g[1];
        return e;
    }
    const std::size_t by = of.kind == BestReach::Kind::touching ? 0 : 1;
    e.f[1] = f.g[by];
    e.rates[2] = f.h[by];
    e.rates[3] = f.h[by + 1];
    return e;
}

std::array<Ball, 4> inverse_of(const std::array<Ball, 4>& m) {
    const Ball det = m[0] * m[3] - m[1] * m[2];
    return {m[3] / det, -(m[1] / det), -(m[2] / det), m[0] / det};
}

bool strictly_inside(const Ball& inner, const Ball& outer) {
    return inner.is_finite() && outer.is_finite() && contains(outer, inner);
}

} // namespace

std::optional<DesignPoint> design_point(const ReachProblem& problem,
                                        const DesignEquations& equations,
                                        const DesignPoint& start) {
    const long bits = start.u.bits();
    Ball x = start.u;
    Ball y = start.parameter;
    Ball last(1, bits);
    std::array<Ball, 4> Y;
    for (int k = 0; k < most_newton_steps_of_a_point; ++k) {
        check_interruption();
        const EquationValues e = equations_at(problem, equations, x, y);
        Y = inverse_of(e.rates);
        for (Ball& entry : Y) {
            if (!entry.is_finite()) {
                return {};
            }
            entry = middle(entry);
        }
        const Ball dx = Y[0] * e.f[0] + Y[1] * e.f[1];
        const Ball dy = Y[2] * e.f[0] + Y[3] * e.f[1];
        if (!dx.is_finite() || !dy.is_finite()) {
            return {};
        }
        const Ball step = middle(max(abs(dx), abs(dy)));
        x = middle(x - dx);
        y = middle(y - dy);
        const bool stalls = k > 6 && !certainly_less(step * 2, last);
        last = step;
        if (stalls) {
            break;
        }
    }
    // Krawczyk's operator: m - Y f(m) + (1 - Y J(X)) (X - m) inside X shows one root in X, and no
    // other (moore-kearfott-cloud2009).
    const EquationValues at = equations_at(problem, equations, x, y);
    Ball radius = last * 16 + power_of_two(-(bits * 3 / 4), bits);
    for (int k = 0; k < most_inflations_of_a_point; ++k) {
        const Ball hx = up_to(radius);
        const Ball X = x + hx;
        const Ball Z = y + hx;
        const EquationValues over = equations_at(problem, equations, X, Z);
        const auto& J = over.rates;
        const Ball kx = x - (Y[0] * at.f[0] + Y[1] * at.f[1]) +
                        (1 - (Y[0] * J[0] + Y[1] * J[2])) * hx - (Y[0] * J[1] + Y[1] * J[3]) * hx;
        const Ball ky = y - (Y[2] * at.f[0] + Y[3] * at.f[1]) - (Y[2] * J[0] + Y[3] * J[2]) * hx +
                        (1 - (Y[2] * J[1] + Y[3] * J[3])) * hx;
        if (strictly_inside(kx, X) && strictly_inside(ky, Z)) {
            return DesignPoint{kx, ky};
        }
        radius = middle(radius * 64);
    }
    return {};
}

namespace {

/// The only root of a function near a start, from its value and derivative over a ball.
template <class ValueAndRate>
std::optional<Ball> isolated_root(const ValueAndRate& f, const Ball& start) {
    const long bits = start.bits();
    Ball x = start;
    Ball last(1, bits);
    for (int k = 0; k < most_newton_steps_of_a_point; ++k) {
        check_interruption();
        const auto [value, rate] = f(x);
        const Ball step = middle(value / rate);
        if (!step.is_finite()) {
            return {};
        }
        x = middle(x - step);
        const bool stalls = k > 6 && !certainly_less(abs(step) * 2, last);
        last = abs(step);
        if (stalls) {
            break;
        }
    }
    const auto [residual, rate] = f(x);
    const Ball by = residual / rate;
    if (!by.is_finite()) {
        return {};
    }
    Ball radius = upper_end(abs(by)) * 2 + power_of_two(-(bits - 16), bits);
    for (int k = 0; k < most_inflations_of_a_point; ++k) {
        const Ball X = Ball::around(x.midpoint(), radius.upper(), bits);
        const Ball image = x - residual / f(X).second;
        if (strictly_inside(image, X)) {
            return image;
        }
        radius = middle(radius * 16);
    }
    return {};
}

} // namespace

std::optional<Ball> exit_near(const ErrorOverBox& f, const Ball& level, const Ball& start) {
    return isolated_root(
        [&](const Ball& u) {
            const BallSeries at = f.along(u, Along::u);
            return std::pair(at[0] - level, at[1]);
        },
        start);
}

std::optional<DesignPoint> touching_at_middle(const ReachProblem& problem,
                                              const DesignEquations& equations, const Ball& start) {
    const Ball level = Ball(problem.tolerance, start.bits()) * equations.side;
    std::optional<Ball> middle;
    const auto root = isolated_root(
        [&](const Ball& t) {
            const auto errors = problem.over(t);
            middle = errors[equations.edge].length / 2;
            const BallSeries at = errors[equations.edge].along(*middle, Along::parameter);
            return std::pair(at[0] - level, at[1]);
        },
        start);
    return root ? std::optional(DesignPoint{*middle, *root}) : std::nullopt;
}

} // namespace edgeproof::contact
