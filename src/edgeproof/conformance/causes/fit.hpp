// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/conformance/answers/agreement.hpp"
#include "edgeproof/precision/real.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

/// Measures of how well a possible cause explains wrong answers. The accuracy of the answers is not
/// known; it is estimated by the scatter of what remains after the cause.
namespace edgeproof::conformance {

/// Wrong answers of one quantity, at both edges or at one.
struct WrongRows {
    std::vector<std::size_t> questions;
    std::vector<Real> answers;
    std::vector<Real> ours; ///< the references
    /// Pairs of rows at neighbouring points of one contact: a smooth remainder is nearly the same
    /// at both, errors of rounding and noise are not.
    std::vector<std::pair<std::size_t, std::size_t>> neighbours;

    [[nodiscard]] std::size_t size() const { return questions.size(); }
};

[[nodiscard]] WrongRows wrong_rows(const Answers& answers, const Agreements& agreements,
                                   std::vector<std::size_t> questions);

/// The relative errors of a group that remain if a cause is corrected.
struct Fit {
    std::vector<double> off;    ///< answer over the value of the cause, minus 1, of each row
    std::vector<double> before; ///< |answer over ours, minus 1|
    std::vector<double> change; ///< |value of the cause over ours, minus 1|
    std::vector<bool> changes;  ///< the cause changes the row clearly
    std::size_t rows = 0;       ///< those changed clearly that follow the cause
    double worst = 0;           ///< the largest |off| of these
    double held = 0;            ///< the |off| that nine of ten rows do not exceed
    double scatter = 0;         ///< the standard deviation, from the median of the absolute values
    /// The cause leaves less than a twenty-fifth of the error, |answer/ours - 1| or |ours/answer -
    /// 1|, of the rows that it changes. Set by fit_of().
    bool dominates = false;
    /// True if the remaining error scatters from point to point, as errors of rounding and noise
    /// do. Empty if there are too few neighbours to decide.
    std::optional<bool> noise_like;
};

inline constexpr std::size_t least_rows = 3;
inline constexpr double least_share = 0.9;
/// Values that agree to this are regarded as equal.
inline constexpr double same_value = 1e-6;
/// Nine rows of ten must agree to this with a cause: larger scatter would hide it.
inline constexpr double most_scatter = 0.12;
/// The same for a remainder that is not known to be noise, unless the cause dominates the error.
inline constexpr double most_remainder = 0.03;
inline constexpr double dominant_gain = 25;
/// The least factor by which a cause must reduce the error.
inline constexpr double least_gain = 4;

/// True if this number of rows suffices to explain the failing ones.
[[nodiscard]] bool enough(std::size_t rows, std::size_t failing);

/// The factor by which the standard deviation of this number of rows may exceed their scatter.
[[nodiscard]] double uncertainty_of_scatter(std::size_t rows);

/// Compares the answers with the values of a cause; rows without a value are not changed by it.
/// There must be one row or more.
[[nodiscard]] Fit remainder_of(const WrongRows& rows,
                               const std::vector<std::optional<Real>>& values);
/// Returns the remainder if nine of ten rows follow it, if it leaves less than a quarter of the
/// error of the rows that it changes (less if they are few), and if these rows have no common
/// factor other than 1 left, within four standard errors (more if they are few): another cause may
/// have nearly the same effect. If the remainder is smooth and not noise, half its size is allowed
/// for that, and all of it if the cause leaves less than a twenty-fifth of the error. `noise`: the
/// least standard deviation of the answers, as far as it is known.
[[nodiscard]] std::optional<Fit>
fit_of(const WrongRows& rows, const std::vector<std::optional<Real>>& values, double noise);

/// The sum of squares of what remains, relative to `scatter`; outliers are limited.
[[nodiscard]] double misfit(const Fit& fit, double scatter);
/// Causes whose misfit exceeds the least by no more than this are not distinguished: 4.5 standard
/// deviations of one parameter. A smooth remainder has few independent values.
[[nodiscard]] double indistinguishable_misfit(const Fit& best);

/// The median of the ratios of the answers to these values, and its standard error, relative;
/// nothing if fewer than nine of ten rows have a value.
struct CommonRatio {
    Real value;
    double error = 0;
    [[nodiscard]] std::string text() const; ///< with its significant digits
};
[[nodiscard]] std::optional<CommonRatio>
common_ratio(const WrongRows& rows, const std::vector<std::optional<Real>>& values);

} // namespace edgeproof::conformance
