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

/// The comparison of |f| with a tolerance, up to a part of the contact, at one edge or at both
/// (then the smaller reach counts).
struct ReachProblem {
    std::vector<const ErrorFamily*> edges; ///< not owned
    Rational tolerance;
    Rational part = 1;                ///< the part of a + b that is considered
    std::size_t parameters = 1;       ///< one or two
    EvaluationCount* count = nullptr; ///< not owned; nothing is counted without it
    [[nodiscard]] std::vector<ErrorOverBox> over(const std::vector<Ball>& box) const;
};

/// The first exit for exact parameters, proved (the scan of docs/extents.md, with second
/// derivatives).
struct ProvedReach {
    Ball reach;
    bool leaves = true;   ///< false: always within the tolerance; the reach is the end of the range
    std::size_t edge = 0; ///< the index of the edge
    int side = 0;         ///< +1: f = tolerance there, -1: f = -tolerance
};
/// Throws BudgetError if the bits do not decide, because the error touches the tolerance.
[[nodiscard]] ProvedReach proved_reach(const ReachProblem& problem,
                                       const std::vector<Rational>& parameters, long bits);

/// The same for all parameters in balls.
[[nodiscard]] ProvedReach proved_reach(const ReachProblem& problem,
                                       const std::vector<Ball>& parameters);

/// An estimate of the same by samples. NaN if no sample has a value.
struct SampledReach {
    double reach = 0;
    double measure = 0; ///< the total length of the places within the tolerance
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
/// `whole`: also compute the measure, for which the whole contact is sampled.
[[nodiscard]] SampledReach sampled_reach(const ReachProblem& problem,
                                         const std::vector<double>& parameters, bool whole = false);

} // namespace edgeproof::contact
