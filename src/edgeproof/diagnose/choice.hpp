// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/diagnose/fit.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace edgeproof::diagnose {

/// A cause that may explain wrong numbers.
struct Candidate {
    enum Rank { common_factor, mistake, other_factor, constant };

    std::string name;
    std::string what; ///< in words
    std::string advice;
    double factor = 1;
    Rank rank = mistake;
    std::optional<std::size_t> source; ///< the index of the mistake that gives the values
    Fit fit = {};
    bool contradicted = false; ///< by right numbers
    double doubtful = 0;       ///< the uncertainty of the common factor

    [[nodiscard]] bool is(const Candidate& other) const {
        return name == other.name && what == other.what;
    }
};

/// The standard deviation by which candidates are distinguished; `noise`: its least value.
[[nodiscard]] double unit_of(const std::vector<Candidate>& candidates, double noise);

/// The greatest misfit of a candidate, in these units, that the numbers do not distinguish from
/// those that explain them. `fit_of`: what a candidate leaves of this number of rows.
[[nodiscard]] double most_misfit(const std::vector<Candidate>& candidates, double unit,
                                 std::size_t rows,
                                 const std::function<Fit(const Candidate&)>& fit_of);

/// Removes the candidates that explain the numbers less well than the best, and those that right
/// numbers contradict, unless no others remain; sorts the others, the most likely first. Increases
/// `noise` to the scatter that the best leaves, if that is noise.
void keep_best(std::vector<Candidate>& candidates, double& noise);

/// True if all causes with a name leave a remainder that is not known to be noise, and that a
/// constant without a name does not leave: one that is nearly the effect of a mistake by chance. If
/// a named factor dominates the error, the numbers must be known to be constant.
[[nodiscard]] bool constant_is_better(const Fit& constant, const std::vector<Candidate>& named,
                                      double noise);
/// True if a constant without a name fits no worse than the causes found by more than two standard
/// deviations (but better by these than a common factor).
[[nodiscard]] bool constant_is_possible(const Fit& constant, const std::vector<Candidate>& named,
                                        double noise);

} // namespace edgeproof::diagnose
