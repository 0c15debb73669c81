// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/design/error_family.hpp"

#include <cstddef>
#include <vector>

namespace edgeproof::contact {

/// The evaluations of a search, weighted by their cost. Beyond `most` they throw BudgetError.
struct EvaluationCount {
    double spent = 0;
    double most = 0;
};

/// |f| against a tolerance, up to a part of the contact, at one edge or at two (where the lesser
/// reach counts).
struct ReachProblem {
    std::vector<const ErrorFamily*> edges; ///< not owned
    Rational tolerance;
    Rational part = 1;                ///< of a + b, that is looked at
    std::size_t parameters = 1;       ///< one or two
    EvaluationCount* count = nullptr; ///< not owned; nothing is counted without it
    [[nodiscard]] std::vector<std::unique_ptr<ErrorOverBox>>
    over(const std::vector<Ball>& box) const;
};

/// The first exit for parameters that are exact: proved (the scan of docs/extents.md, with second
/// derivatives).
struct ProvedReach {
    Ball reach;
    bool leaves = true;   ///< false: within the tolerance all over; the reach is the range's end
    std::size_t edge = 0; ///< at which of the edges
    int side = 0;         ///< +1: f = tolerance there, -1: f = -tolerance
};
/// Throws BudgetError where the bits do not decide: the error touches the tolerance.
[[nodiscard]] ProvedReach proved_reach(const ReachProblem& problem,
                                       const std::vector<Rational>& parameters, long bits);

/// For numbers known by balls, every one of them.
[[nodiscard]] ProvedReach proved_reach(const ReachProblem& problem,
                                       const std::vector<Ball>& parameters);

/// About the same by samples: proves nothing. NaN where nothing is known.
struct SampledReach {
    double reach = 0;
    double measure = 0; ///< of all places within the tolerance
    bool leaves = true;
    std::size_t edge = 0;
    int side = 0;
    /// Extrema of |f| before the exit that are near the tolerance, nearest first.
    struct Extremum {
        std::size_t edge;
        double u;
        double excess; ///< |f| - tolerance
        int side;
    };
    std::vector<Extremum> extrema;
};
/// `whole`: the measure as well, for which all of the contact is looked at.
[[nodiscard]] SampledReach sampled_reach(const ReachProblem& problem,
                                         const std::vector<double>& parameters, bool whole = false);

} // namespace edgeproof::contact
