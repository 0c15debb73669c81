// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/design/reach.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

/// The parameters for which n terms stay within a tolerance for the longest distance from an edge.
/// docs/design.md has the argument.
namespace edgeproof::contact {

struct ParameterRange {
    Rational from;
    Rational to;
};

struct DesignOptions {
    unsigned digits = 30;     ///< of the value and of the reach, with one parameter
    Rational gap{1, 1000000}; ///< by which nothing else in the range may do better
    std::size_t most_boxes = 100'000;
    /// How much of the range is done, in thousandths.
    std::function<void(std::size_t done, std::size_t total)> progress = {};
};

struct BestReach {
    enum class Kind {
        touching,     ///< an inner extremum of the error touches the tolerance
        smooth,       ///< the reach has an ordinary maximum
        two_edges,    ///< both edges reach equally far
        end_of_range, ///< an end of the parameter's range
        everywhere,   ///< within the tolerance all over the part that is looked at
        box           ///< known by the search alone: the box of the best value tried
    };
    Kind kind = Kind::box;
    std::vector<Ball> value; ///< of each parameter
    Ball reach;              ///< what is approached as the parameter goes to that value
    /// False where the reach jumps there: it is approached from one side.
    bool attained = true;
    std::optional<Ball> touches_at; ///< where the error touches the tolerance
    /// Shown by a proof of its own: exact parameters by the best ones, and their reach.
    std::vector<Rational> shown_at;
    Ball shown_reach;
    /// Every reach of the range is at most shown_reach + gap: proved by branch and bound.
    bool proved = false;
    std::size_t boxes = 0;
    std::string missing; ///< why it is not proved
};

/// Throws BudgetError where not even an estimate is found.
[[nodiscard]] BestReach best_reach(const ReachProblem& problem,
                                   const std::vector<ParameterRange>& ranges,
                                   const DesignOptions& options);

/// About the best value by samples alone, and its reach (or measure): an estimate.
struct SampledBest {
    std::vector<double> value;
    std::vector<double> width; ///< of what is left of the range
    double score = 0;
};
/// How many values are tried: cells of the first grid and of later ones, and how many of these.
struct SampleGrid {
    int first = 96;
    int later = 16;
    int rounds = 14; ///< to what binary64 tells apart: beside a root of the parameter it counts
    [[nodiscard]] static SampleGrid of(std::size_t parameters) {
        return parameters == 1 ? SampleGrid{} : SampleGrid{24, 6, 14};
    }
    /// All of them, ends of cells included.
    [[nodiscard]] std::size_t count(std::size_t parameters) const {
        const auto cells = [&](int per_side) {
            const auto n = static_cast<std::size_t>(per_side) + 1;
            return parameters == 1 ? n : n * n;
        };
        return cells(first) + static_cast<std::size_t>(rounds) * cells(later);
    }
    /// Where a value takes long.
    [[nodiscard]] static SampleGrid coarse(std::size_t parameters) {
        return parameters == 1 ? SampleGrid{24, 8, 4} : SampleGrid{8, 4, 4};
    }
};
[[nodiscard]] SampledBest
sampled_best(const std::function<double(const std::vector<double>&)>& score,
             const std::vector<ParameterRange>& ranges, const SampleGrid& samples);

/// Branch and bound over the range: every box has a distance up to `target` at which the error is
/// certainly beyond the tolerance for all its parameters.
struct CoveredRange {
    bool covered = false;
    std::size_t boxes = 0;
    std::string where;          ///< not covered
    std::vector<double> middle; ///< of the box there
};
[[nodiscard]] CoveredRange covered_by_exits(const ReachProblem& problem,
                                            const std::vector<ParameterRange>& ranges,
                                            const Rational& target, const DesignOptions& options);

/// A point (distance, parameter) at which two equations hold, by interval Newton.
struct DesignPoint {
    Ball u;
    Ball parameter;
};
struct DesignEquations {
    BestReach::Kind kind = BestReach::Kind::touching; ///< touching, smooth or two_edges
    std::size_t edge = 0;
    int side = 1;       ///< of the tolerance
    int other_side = 1; ///< two_edges: at the second edge
};
/// The one solution near a start, to so many bits; nothing where it is not isolated.
[[nodiscard]] std::optional<DesignPoint> design_point(const ReachProblem& problem,
                                                      const DesignEquations& equations,
                                                      const Real& u, const Real& parameter,
                                                      long bits);
/// The root of f = side * tolerance near a start, for every parameter of the ball.
[[nodiscard]] std::optional<Ball> exit_near(const ErrorOverBox& f, const Ball& level,
                                            const Real& start, long bits);

} // namespace edgeproof::contact
