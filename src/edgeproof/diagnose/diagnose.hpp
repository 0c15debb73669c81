// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/precision/real.hpp"
#include "edgeproof/scene/input/scene_file.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// Measures of how well a possible cause explains wrong numbers. The accuracy of the numbers is not
/// known; it is estimated by the scatter of what remains after the cause.
namespace edgeproof::diagnose {

/// The relative errors of wrong numbers, before and after a cause is corrected.
struct Remainders {
    std::vector<double> off;    ///< the number over the value of the cause, minus 1
    std::vector<double> before; ///< |number/right - 1|
    std::vector<double> ratio;  ///< the larger of `before` and |right/number - 1|
    std::vector<double> change; ///< |value of the cause/right - 1|; 0 without a value
    /// Pairs at neighbouring points of one contact: a smooth remainder is nearly the same at both,
    /// errors of rounding and noise are not.
    std::vector<std::pair<std::size_t, std::size_t>> neighbours;
};

struct Fit {
    std::vector<double> off;   ///< as in Remainders
    std::vector<bool> changes; ///< the cause changes the number clearly
    std::size_t rows = 0;      ///< those changed clearly that follow the cause
    double worst = 0;          ///< the largest |off| of these
    double held = 0;           ///< the |off| that nine of ten rows do not exceed
    double scatter = 0;        ///< the standard deviation, from the median of the absolute values
    /// The cause leaves less than a twenty-fifth of the error, |number/right - 1| or |right/number
    /// - 1|, of the rows that it changes. Set by fit_of().
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
/// The least factor by which a cause must reduce the error.
inline constexpr double least_gain = 4;

/// The value that this share of a list does not exceed.
[[nodiscard]] double sorted_at(std::vector<double> list, double share);

/// True if this number of rows suffices to explain the failing ones.
[[nodiscard]] bool enough(std::size_t rows, std::size_t failing);

/// The relative standard error of the median of some numbers, from their |errors|.
[[nodiscard]] double error_of_median(std::vector<double> about);

/// A number that is fitted to data, with its standard error from their scatter.
struct FittedFactor {
    double value = 1;
    double error = 0;

    [[nodiscard]] std::string text() const; ///< with the digits that the data determine
};
/// The relative differences of data from the values with a factor; NaN without a value.
using Residuals = std::function<std::vector<double>(double)>;
/// The factor, of 1/10 to 10, for which the sum of the absolute differences is least: that of some
/// data by trial and golden section, then that of all by the weighted median of their own factors.
/// Returns nothing if half of some data differ by more than most_scatter, or if the factor is 1
/// within three standard errors.
[[nodiscard]] std::optional<FittedFactor> fitted_factor(const Residuals& of_some,
                                                        const Residuals& of_all);

/// Measures what remains; rows without a value of the cause are not changed by it. There must be
/// one row or more.
[[nodiscard]] Fit remainder_of(Remainders rows);
/// Returns the remainder if nine of ten rows follow it, if it leaves less than a quarter of the
/// error of the rows that it changes (less if they are few), and if these rows have no common
/// factor other than 1 left, within four standard errors (more if they are few): another cause may
/// have nearly the same effect. If the remainder is smooth and not noise, half its size is allowed
/// for that, and all of it if the cause leaves less than a twenty-fifth of the error. `noise`: the
/// least standard deviation of the numbers, as far as it is known; `allowance`: the root mean
/// square of the error that the method of the numbers has by itself, if it is known.
[[nodiscard]] std::optional<Fit> fit_of(const Remainders& rows, double noise,
                                        const std::optional<double>& allowance = {});
/// True if what remains is noise, or within the allowance, and has no common factor.
[[nodiscard]] bool is_noise(const Fit& fit, double allowance);

/// True if what remains scatters as noise does, or no more than the numbers do.
[[nodiscard]] bool is_accurate(const Fit& fit, double noise);

/// The mean square of what remains, relative to `scatter`; outliers are limited.
[[nodiscard]] double misfit(const Fit& fit, double scatter);

/// A number as a program wrote it, and its error.
struct Written {
    std::string text; ///< a decimal, or a hexadecimal float
    double value = 0;
    double error = 0;
    double explained = 0; ///< the part of the error that has another cause
    double size = 0;      ///< that errors of binary32 are relative to
};

/// Numbers with fewer digits than a double has.
struct FewDigits {
    std::string name;              ///< rounded-to-5, rounded-to-3-decimals or binary32
    std::string digits;            ///< "5 digits", "3 decimals"; empty for binary32
    std::vector<std::size_t> rows; ///< the numbers explained
};

/// Finds numbers whose errors are explained by their digits: nine of ten are wrong by no more than
/// half a unit of the last digit (or decimal) that nine of ten carry, trailing zeros apart; or nine
/// of ten of those with five digits right are binary32 numbers, and this is no chance. Numbers that
/// are wrong by up to a whole unit are explained, too.
[[nodiscard]] std::optional<FewDigits> few_digits(const std::vector<Written>& numbers);

/// A cause that may explain wrong numbers.
struct Candidate {
    enum Rank { common_factor, mistake, other_factor, constant };

    std::string name;
    std::string what; ///< in words
    std::string advice;
    Real factor = 1;
    Rank rank = mistake;
    std::optional<std::size_t> source = {}; ///< the index of the mistake that gives the values
    Fit fit = {};
    bool contradicted = false; ///< by right numbers

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

/// A factor of values with a cause: 2, pi, units of other systems, -1, ...
struct NamedFactor {
    Real value;
    std::string words; ///< "2 times ", "sqrt(2 pi) times ", "minus "
    const char* hint;
    const char* name;
    bool common; ///< more likely than a mistake in the data of a scene
};
[[nodiscard]] std::vector<NamedFactor> named_factors();
/// True if a quantity ("p", "c_k", ...) may be wrong by the factor of this name.
[[nodiscard]] inline bool is_possible(std::string_view factor, std::string_view quantity) {
    return factor != "mean-for-peak" || quantity == "p" || quantity == "c_k";
}

struct NearFactor {
    NamedFactor factor;
    double rest; ///< the greatest relative error that it leaves
};
/// Returns the named factors k near numbers of `least` to `most` times the right ones: the rest,
/// which has another cause, is at most a tenth, and a quarter of the error |k - 1| or |1/k - 1|,
/// and k is not further from the interval than this is wide (unless they are a constant). If the
/// nearest is just within these limits, those that are nearly as near are added, too: the numbers
/// do not distinguish them.
[[nodiscard]] std::vector<NearFactor> near_factors(double least, double most);

/// A mistake in the data of a scene: one of the catalogue of the mistakes that programs make, for
/// which `edgeproof compare` and `edgeproof check` search with the same names.
struct Mistake {
    std::string_view name;   ///< the name of the cause in the output; several mistakes may share it
    std::string what;        ///< in words, without a verb: "the diameter instead of the radius"
    std::string_view advice; ///< what is right
    std::function<void(scene::Scene&)> change; ///< makes the scene that such a program solves
};

/// The possible mistakes in the moduli, the profile and the load. The changed scene need not have a
/// contact. The functions do not refer to `scene`.
[[nodiscard]] std::vector<Mistake> contact_mistakes(const scene::Scene& scene);
/// Multiplies the load that a scene gives, at each step of a history, and its moment.
void scale_load(scene::Scene& scene, const Rational& factor);
/// The possible mistakes in [shear], for a scene that has it.
[[nodiscard]] std::vector<Mistake> shear_mistakes(const scene::Scene& scene);

} // namespace edgeproof::diagnose
