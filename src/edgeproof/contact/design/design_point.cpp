// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/design/best_reach.hpp"
#include "edgeproof/contact/stress/isolated_pair.hpp"

#include <cstddef>

namespace edgeproof::contact {
namespace {

/// The equations in u and the parameter.
PairOfEquations equations_at(const ReachProblem& problem, const DesignEquations& of,
                             const BallPair& at) {
    const auto& [u, parameter] = at;
    const Ball level(problem.tolerance, u.bits());
    const auto errors = problem.over(parameter);
    const Jet f = errors[of.edge].jet(u);
    const Ball off = f.v - level * of.side;
    if (of.kind == BestReach::Kind::two_edges) {
        const Jet other = errors[1 - of.edge].jet(u);
        return {{off, other.v - level * of.other_side}, {{f.g, other.g}}};
    }
    const std::size_t by = of.kind == BestReach::Kind::touching ? 0 : 1;
    return {{off, f.g[by]}, {{f.g, {f.h[by], f.h[by + 1]}}}};
}

} // namespace

std::optional<DesignPoint> design_point(const ReachProblem& problem,
                                        const DesignEquations& equations,
                                        const DesignPoint& start) {
    const auto at =
        isolated_pair([&](const BallPair& x) { return equations_at(problem, equations, x); },
                      {start.u, start.parameter});
    return at ? std::optional(DesignPoint{(*at)[0], (*at)[1]}) : std::nullopt;
}

std::optional<Ball> exit_near(const ErrorOverBox& f, const Ball& level, const Ball& start) {
    const Ball zero(0, start.bits());
    const auto at = isolated_pair(
        [&](const BallPair& x) -> PairOfEquations {
            const BallSeries value = f.along(x[0], Along::u);
            return {{value[0] - level, zero}, {{{value[1], zero}, {zero, zero}}}};
        },
        {start, zero}, {true, false});
    return at ? std::optional((*at)[0]) : std::nullopt;
}

std::optional<DesignPoint> touching_at_middle(const ReachProblem& problem,
                                              const DesignEquations& equations, const Ball& start) {
    const Ball zero(0, start.bits());
    const auto half_length = [&](const Ball& parameter) {
        return problem.over(parameter)[equations.edge].length / 2;
    };
    const auto at = isolated_pair(
        [&](const BallPair& x) -> PairOfEquations {
            const auto errors = problem.over(x[0]);
            const ErrorOverBox& f = errors[equations.edge];
            const BallSeries value = f.along(f.length / 2, Along::parameter);
            const Ball level = Ball(problem.tolerance, start.bits()) * equations.side;
            return {{value[0] - level, zero}, {{{value[1], zero}, {zero, zero}}}};
        },
        {start, zero}, {true, false});
    return at ? std::optional(DesignPoint{half_length((*at)[0]), (*at)[0]}) : std::nullopt;
}

} // namespace edgeproof::contact
