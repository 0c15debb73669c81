// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/contact/design/error_family.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// The parameter for which n terms stay within a tolerance for the longest distance from an edge.
/// docs/design.md has the argument.
namespace edgeproof::contact {

/// The evaluations of a search, weighted by their cost. Beyond `most` they throw BudgetError.
struct EvaluationCount {
    double spent = 0;
    double most = 0;
};

/// The comparison of |f| with a tolerance, up to a part of the contact, at one edge or at both
/// (then the smaller reach counts).
struct ReachProblem {
    std::vector<ErrorFamily> edges;
    Rational tolerance;
    Rational part = 1;                ///< the part of a + b that is considered
    EvaluationCount* count = nullptr; ///< not owned; nothing is counted without it
    [[nodiscard]] std::vector<ErrorOverBox> over(const Ball& parameter) const;
};

/// The first exit for all parameters in a ball, proved (the scan of docs/expansions.md, with second
/// derivatives).
struct ProvedReach {
    Ball reach;
    bool leaves = true;   ///< false: always within the tolerance; the reach is the end of the range
    std::size_t edge = 0; ///< the index of the edge
    int side = 0;         ///< +1: f = tolerance there, -1: f = -tolerance
};
/// Throws BudgetError if the bits do not decide, because the error touches the tolerance.
[[nodiscard]] ProvedReach proved_reach(const ReachProblem& problem, const Ball& parameter);
/// The same for a binary64 with few bits; nothing where it is not decided.
[[nodiscard]] std::optional<ProvedReach> reach_near(const ReachProblem& problem, double parameter);
/// An estimate of the total length of the places within the tolerance, by samples. NaN if there is
/// none.
[[nodiscard]] double sampled_measure(const ReachProblem& problem, double parameter);

struct ParameterRange {
    Rational from;
    Rational to;
};

/// Returns a text such as "0.1 ... 0.2", rounded outwards.
[[nodiscard]] std::string range_text(const ParameterRange& range);

struct DesignOptions {
    unsigned digits = 30;     ///< of the value and of the reach
    Rational gap{1, 1000000}; ///< no other value of the range may reach farther by more than this
    std::size_t most_boxes = 100'000;
    /// The cost of all evaluations (EvaluationCost): about 15 s if nothing is decided.
    double budget = 14e6;
    /// Called with the part of the range that is done, in thousandths.
    std::function<void(std::size_t done, std::size_t total)> progress = {};
};

struct BestReach {
    enum class Kind {
        touching,     ///< an inner extremum of the error touches the tolerance
        smooth,       ///< the reach has an ordinary maximum
        two_edges,    ///< both edges reach equally far
        end_of_range, ///< an end of the parameter's range
        everywhere,   ///< within the tolerance in the whole part considered
        box           ///< known only by the search
    };
    Kind kind = Kind::box;
    /// For the kind `box`, if proved, it contains all values that are not proved to reach less than
    /// shown_reach.
    Ball value;
    Ball reach; ///< the limit as the parameter tends to that value
    /// False if the reach jumps there: the limit exists on one side only.
    bool attained = true;
    std::optional<Ball> touches_at; ///< where the error touches the tolerance
    /// An exact parameter near the best one; its reach is proved separately.
    std::optional<Rational> shown_at;
    Ball shown_reach;
    /// Every reach of the range is at most shown_reach + gap: proved by branch and bound.
    bool proved = false;
    std::size_t boxes = 0;
    /// The least range that holds all values that are not proved to reach less than shown_reach.
    std::optional<ParameterRange> not_excluded;
    std::string missing; ///< why it is not proved
};

/// Throws BudgetError if not even an estimate is found.
[[nodiscard]] BestReach best_reach(const ReachProblem& problem, const ParameterRange& range,
                                   const DesignOptions& options);

/// An estimate of the best value and of its reach (or measure), by samples only.
struct SampledBest {
    std::optional<double> value;
    double width = 0; ///< the width of the remaining range
    double score = 0;
};
/// The numbers of values that are tried: the cells of the first grid and of the later ones, and
/// the number of later grids.
struct SampleGrid {
    int first = 96;
    int later = 8;
    int rounds =
        21; ///< until binary64 cannot separate values; this matters near a root of the parameter
    /// The number of all values, with the ends of cells.
    [[nodiscard]] int count() const { return first + 1 + rounds * (later + 1); }
};
[[nodiscard]] SampledBest sampled_best(const std::function<double(double)>& score,
                                       const ParameterRange& range, const SampleGrid& samples);

/// The result of branch and bound over the range. In every box that is not open there is a distance
/// up to `shown` + gap at which the error certainly exceeds the tolerance for all its parameters.
struct CoveredRange {
    bool covered = false;
    std::size_t boxes = 0;
    std::optional<ParameterRange> open; ///< the hull of all boxes without such a distance
    /// The hull of the open boxes and of those whose distance is above `shown`. It contains the
    /// best value.
    std::optional<ParameterRange> best;
    /// A box whose middle reaches farther than `shown` + gap: the search ended there.
    std::optional<ParameterRange> better;
};
[[nodiscard]] CoveredRange covered_by_exits(const ReachProblem& problem,
                                            const ParameterRange& range, const Rational& shown,
                                            const DesignOptions& options);

/// A point (distance, parameter) at which two equations hold, by interval Newton.
struct DesignPoint {
    Ball u;
    Ball parameter;
};
struct DesignEquations {
    BestReach::Kind kind = BestReach::Kind::touching; ///< touching, smooth or two_edges
    std::size_t edge = 0;
    int side = 1;       ///< the sign of the error at the tolerance
    int other_side = 1; ///< for two_edges: that sign at the second edge
};
/// Returns the only solution near a start, to the bits of the start; nothing if it is not isolated.
[[nodiscard]] std::optional<DesignPoint> design_point(const ReachProblem& problem,
                                                      const DesignEquations& equations,
                                                      const DesignPoint& start);
/// The same for a touching extremum at the middle of the contact, where f may have a cusp: only the
/// parameter is unknown.
[[nodiscard]] std::optional<DesignPoint> touching_at_middle(const ReachProblem& problem,
                                                            const DesignEquations& equations,
                                                            const Ball& start);
/// Encloses the root of f = level near a start, for every parameter of the ball.
[[nodiscard]] std::optional<Ball> exit_near(const ErrorOverBox& f, const Ball& level,
                                            const Ball& start);

} // namespace edgeproof::contact
