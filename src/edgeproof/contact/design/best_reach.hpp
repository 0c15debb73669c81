// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/design/reach.hpp"

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// The parameters for which n terms stay within a tolerance for the longest distance from an edge.
/// docs/design.md has the argument.
namespace edgeproof::contact {

struct ParameterRange {
    Rational from;
    Rational to;
};

/// "0.1 ... 0.2, 1 ... 2", rounded outwards.
[[nodiscard]] std::string text_of(const std::vector<ParameterRange>& ranges);

struct DesignOptions {
    unsigned digits = 30;     ///< of the value and of the reach, with one parameter
    Rational gap{1, 1000000}; ///< by which nothing else in the range may do better
    std::size_t most_boxes = 100'000;
    /// Of the evaluations (EvaluationCost): some 15 s where nothing is decided.
    double budget = 14e6;
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
        box           ///< known by the search alone
    };
    Kind kind = Kind::box;
    /// Of each parameter. Of the kind `box`, where it is proved: all values that are not proved to
    /// reach less than shown_reach.
    std::vector<Ball> value;
    Ball reach; ///< what is approached as the parameter goes to that value
    /// False where the reach jumps there: it is approached from one side.
    bool attained = true;
    std::optional<Ball> touches_at; ///< where the error touches the tolerance
    /// Shown by a proof of its own: exact parameters by the best ones, and their reach.
    std::vector<Rational> shown_at;
    Ball shown_reach;
    /// Every reach of the range is at most shown_reach + gap: proved by branch and bound.
    bool proved = false;
    std::size_t boxes = 0;
    /// The least box that holds all values that are not proved to reach less than shown_reach.
    std::vector<ParameterRange> not_excluded;
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
    [[nodiscard]] static SampleGrid of(std::size_t parameters, bool costly = false) {
        return parameters == 1 ? (costly ? SampleGrid{24, 8, 14} : SampleGrid{})
                               : (costly ? SampleGrid{8, 4, 8} : SampleGrid{24, 6, 14});
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
        return parameters == 1 ? SampleGrid{16, 6, 4} : SampleGrid{5, 3, 3};
    }
};
[[nodiscard]] SampledBest
sampled_best(const std::function<double(const std::vector<double>&)>& score,
             const std::vector<ParameterRange>& ranges, const SampleGrid& samples);

/// Branch and bound over the range: every box has a distance up to `shown` + gap at which the error
/// is certainly beyond the tolerance for all its parameters.
struct CoveredRange {
    bool covered = false;
    std::size_t boxes = 0;
    std::vector<ParameterRange> open; ///< the hull of all boxes without such a distance
    /// The hull of those and of all whose distance is above `shown`: the best value is in it.
    std::vector<ParameterRange> best;
    /// A box whose middle seems to reach farther than `shown` + gap: the search ended there.
    std::optional<std::vector<ParameterRange>> better;
};
[[nodiscard]] CoveredRange covered_by_exits(const ReachProblem& problem,
                                            const std::vector<ParameterRange>& ranges,
                                            const Rational& shown, const DesignOptions& options);

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
/// The same of a touching extremum at the middle of the contact, where f may have a cusp: the
/// parameter alone is unknown.
[[nodiscard]] std::optional<DesignPoint> touching_at_middle(const ReachProblem& problem,
                                                            std::size_t edge, int side,
                                                            const Real& parameter, long bits);
/// The one root of a function near a start, from its value and derivative over a ball.
using ValueAndRate = std::function<std::pair<Ball, Ball>(const Ball&)>;
[[nodiscard]] std::optional<Ball> isolated_root(const ValueAndRate& f, const Real& start,
                                                long bits);
/// The root of f = side * tolerance near a start, for every parameter of the ball.
[[nodiscard]] std::optional<Ball> exit_near(const ErrorOverBox& f, const Ball& level,
                                            const Real& start, long bits);

} // namespace edgeproof::contact
