// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/diagnose/diagnose.hpp"
#include "edgeproof/formula/exact/exact.hpp"
#include "edgeproof/io/text_file.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace edgeproof::diagnose {

namespace {

/// A row follows a cause that nine of ten follow to `held` if it does so to three times that.
constexpr double of_held = 3;
/// As most_scatter, for a remainder that is not known to be noise.
constexpr double most_remainder = 0.03;
constexpr double dominant_gain = 25;
constexpr double deviations_of_median = 4;
constexpr double deviations_of_change = 3; ///< the least change of an answer by a cause
constexpr std::size_t rows_for_scatter = 6;
constexpr double rows_for_less_gain = 6;  // with this number of rows, twice the gain is needed
constexpr double rows_for_less_error = 4; // the scatter of few rows is not well known
constexpr double of_a_median = 1.25;      // the standard error of a median, over that of a mean
constexpr double of_a_deviation = 1.483;  // a standard deviation over the median of absolute values
constexpr std::size_t least_neighbours = 6;
/// Half the mean square of the differences of neighbours, over the variance, is 1 for noise, with a
/// standard deviation of 1 over the root of their number.
constexpr double like_noise = 0.4;
constexpr double deviations_of_noise = 3.5;
constexpr double of_allowance = 2; // nine of ten values, over the root mean square
constexpr double of_smooth = 3;    // the same of what a cause leaves
constexpr double rounding = 1e-7;  // smaller scatter is not used to distinguish causes
/// Many causes are tried, and a constant is fitted to the numbers: chance may favour it by more.
constexpr double favour_of_constant = 2;

std::vector<double> absolute(std::vector<double> list) {
    for (double& x : list) {
        x = std::abs(x);
    }
    return list;
}

/// The factor by which the standard deviation of this number of rows may exceed their scatter.
double uncertainty_of_scatter(std::size_t rows) {
    return 1 + rows_for_less_error / static_cast<double>(rows);
}

double root(std::size_t n) { return std::sqrt(static_cast<double>(std::max<std::size_t>(n, 1))); }

/// Half the mean square of the differences of neighbours, over the mean square about the median.
std::optional<bool> is_noise_like(const Remainders& rows, double held) {
    const std::vector<double>& off = rows.off;
    if (rows.neighbours.size() < least_neighbours) {
        return {};
    }
    const double middle = sorted_at(off, 0.5);
    const double most = of_held * held;
    const auto limited = [&](std::size_t i) { return std::clamp(off[i] - middle, -most, most); };
    double differences = 0;
    double all = 0;
    for (const auto& [i, k] : rows.neighbours) {
        const double apart = limited(i) - limited(k);
        differences += apart * apart / 2;
        all += (limited(i) * limited(i) + limited(k) * limited(k)) / 2;
    }
    const double least =
        std::max(like_noise, 1 - deviations_of_noise / root(rows.neighbours.size()));
    // Roundoff of a constant remainder need not look like noise.
    const double roundoff = rounding * rounding * static_cast<double>(rows.neighbours.size());
    return all <= roundoff || differences > least * all;
}

/// True if the median differs from 0 by more than four standard errors, with a deviation of at
/// least `noise`, and by more than is allowed.
bool has_common_factor(const std::vector<double>& off, double noise, double allowed) {
    const double middle = sorted_at(off, 0.5);
    std::vector<double> about = off;
    for (double& x : about) {
        x = std::abs(x - middle);
    }
    const double deviation = std::max(of_a_deviation * sorted_at(std::move(about), 0.5), noise);
    const double error =
        of_a_median * deviation * uncertainty_of_scatter(off.size()) / root(off.size());
    return std::abs(middle) > std::max({same_value, deviations_of_median * error, allowed});
}

/// Causes whose misfit exceeds the least, of this number of rows, by no more than this are not
/// distinguished: 4.5 standard deviations of one parameter. A smooth remainder has few independent
/// values.
double indistinguishable_misfit(const Fit& best, std::size_t rows) {
    constexpr double of_noise = 20;
    constexpr double independent_values = 5;
    const double of_one = of_noise / static_cast<double>(rows);
    const auto size = static_cast<double>(best.off.size());
    return best.noise_like.value_or(true) ? of_one
                                          : of_one * std::max(1.0, size / independent_values);
}

} // namespace

double sorted_at(std::vector<double> list, double share) {
    const auto at =
        list.begin() + static_cast<long>(share * static_cast<double>(list.size() - 1) + 0.5);
    std::nth_element(list.begin(), at, list.end());
    return *at;
}

bool enough(std::size_t rows, std::size_t failing) {
    return rows >= least_rows &&
           static_cast<double>(rows) >= least_share * static_cast<double>(failing);
}

double error_of_median(std::vector<double> about) {
    const double of_root = of_a_median * of_a_deviation / root(about.size());
    return of_root * sorted_at(std::move(about), 0.5);
}

Fit remainder_of(Remainders rows) {
    Fit fit;
    fit.held = sorted_at(absolute(rows.off), least_share);
    fit.scatter = of_a_deviation * sorted_at(absolute(rows.off), 0.5);
    fit.noise_like = is_noise_like(rows, fit.held);
    for (std::size_t k = 0; k < rows.off.size(); ++k) {
        const bool changes =
            rows.change[k] > std::max(same_value, deviations_of_change * fit.scatter);
        const bool follows = std::abs(rows.off[k]) <= std::max(same_value, of_held * fit.held);
        fit.changes.push_back(changes);
        if (changes && follows) {
            ++fit.rows;
            fit.worst = std::max(fit.worst, std::abs(rows.off[k]));
        }
    }
    fit.off = std::move(rows.off);
    return fit;
}

std::optional<Fit> fit_of(const Remainders& rows, double noise,
                          const std::optional<double>& allowance) {
    const double most_smooth = allowance ? of_smooth * *allowance : most_remainder;
    const std::size_t size = rows.off.size();
    if (size < least_rows) {
        return {};
    }
    Fit fit = remainder_of(rows);
    // A few rows of much scatter agree with some named factor by chance.
    if (!(fit.held <= (size < rows_for_scatter ? most_remainder : most_scatter))) {
        return {};
    }
    std::vector<double> left;
    std::vector<double> left_before;
    std::vector<double> of_ratio; // as large for 1/2 as for 2
    for (std::size_t k = 0; k < size; ++k) {
        if (fit.changes[k]) {
            left.push_back(rows.off[k]);
            left_before.push_back(rows.before[k]);
            of_ratio.push_back(rows.ratio[k]);
        }
    }
    if (!enough(fit.rows, left.size())) {
        return {};
    }
    // If it is noise, all rows show its size.
    const std::vector<double>& of_size = fit.noise_like.value_or(false) ? fit.off : left;
    const double left_half = sorted_at(absolute(of_size), 0.5);
    const double gain = least_gain * (1 + rows_for_less_gain / static_cast<double>(of_size.size()));
    fit.dominates = sorted_at(std::move(of_ratio), 0.5) >= dominant_gain * left_half;
    if (sorted_at(std::move(left_before), 0.5) < gain * left_half ||
        (fit.held > std::max(most_smooth, of_held * noise) && !fit.dominates &&
         !fit.noise_like.value_or(false))) {
        return {};
    }
    const double smooth =
        fit.noise_like.value_or(!fit.dominates) ? 0 : fit.held / (fit.dominates ? 1 : 2);
    return has_common_factor(left, noise, std::max(smooth, allowance.value_or(0)))
               ? std::nullopt
               : std::optional(std::move(fit));
}

bool is_noise(const Fit& fit, double allowance) {
    return (fit.noise_like.value_or(false) || fit.held <= of_allowance * allowance) &&
           !has_common_factor(fit.off, 0, allowance);
}

bool is_accurate(const Fit& fit, double noise) {
    return fit.noise_like.value_or(fit.held <= std::max(same_value, 3 * noise));
}

double misfit(const Fit& fit, double scatter) {
    const double unit = std::max(scatter, rounding);
    constexpr double most = 5;
    double sum = 0;
    for (const double off : fit.off) {
        const double deviations = std::min(std::abs(off) / unit, most);
        sum += deviations * deviations;
    }
    return sum / static_cast<double>(fit.off.size());
}

double unit_of(const std::vector<Candidate>& candidates, double noise) {
    const auto scatter = [](const Candidate& c) { return c.fit.scatter; };
    const double least = scatter(*std::ranges::min_element(candidates, {}, scatter));
    return std::max(least * uncertainty_of_scatter(candidates.front().fit.off.size()), noise);
}

double most_misfit(const std::vector<Candidate>& candidates, double unit, std::size_t rows,
                   const std::function<Fit(const Candidate&)>& fit_of) {
    double least = std::numeric_limits<double>::max();
    for (const Candidate& c : candidates) {
        least = std::min(least, misfit(fit_of(c), unit));
    }
    return least + indistinguishable_misfit(candidates.front().fit, rows);
}

void keep_best(std::vector<Candidate>& candidates, double& noise) {
    if (!std::ranges::all_of(candidates, &Candidate::contradicted)) {
        std::erase_if(candidates, &Candidate::contradicted);
    }
    if (candidates.empty()) {
        return;
    }
    const double unit = unit_of(candidates, noise);
    const auto misfit_in_units = [&](const Candidate& c) { return misfit(c.fit, unit); };
    const Candidate& best = *std::ranges::min_element(candidates, {}, misfit_in_units);
    const bool constant = best.rank == Candidate::constant;
    const double most =
        misfit_in_units(best) + (constant ? favour_of_constant : 1) *
                                    indistinguishable_misfit(best.fit, best.fit.off.size());
    if (best.fit.noise_like.value_or(false)) {
        noise = std::max(noise, best.fit.scatter);
    }
    // The rest after a common factor may nearly be a constant.
    const bool may_vary = constant && !best.fit.noise_like.value_or(best.fit.held <= same_value);
    std::erase_if(candidates, [&](const Candidate& c) {
        return misfit_in_units(c) > most &&
               !(may_vary && c.rank == Candidate::common_factor && c.fit.dominates);
    });
    std::ranges::stable_sort(candidates, {}, [&](const Candidate& c) {
        return std::pair(c.rank, c.rank == Candidate::mistake ? 0 : misfit_in_units(c));
    });
}

bool constant_is_better(const Fit& constant, const std::vector<Candidate>& named, double noise) {
    const double unit = std::max(constant.scatter, noise);
    const bool is_constant = constant.noise_like.value_or(constant.held <= same_value);
    return std::ranges::all_of(named, [&](const Candidate& c) {
        return !c.fit.noise_like.value_or(false) && (is_constant || !c.fit.dominates) &&
               misfit(c.fit, unit) >
                   misfit(constant, unit) + indistinguishable_misfit(c.fit, c.fit.off.size());
    });
}

bool constant_is_possible(const Fit& constant, const std::vector<Candidate>& named, double noise) {
    const double two_deviations = 4 / static_cast<double>(constant.off.size());
    const double unit = std::max(constant.scatter, noise);
    return is_accurate(constant, noise) && std::ranges::all_of(named, [&](const Candidate& c) {
               const bool common = c.rank == Candidate::common_factor;
               return misfit(constant, unit) <=
                      misfit(c.fit, unit) + (common ? -two_deviations : two_deviations);
           });
}

namespace {

constexpr const char* modulus_hint =
    "the modulus of one body, E/(1 - nu^2), taken for that of both? contact_modulus is E* with "
    "1/E* = (1 - nu1^2)/E1 + (1 - nu2^2)/E2 (or a full width for a half-width); scale by the "
    "inverse";
constexpr const char* half_hint =
    "2 E* or an older compliance A = 1/E* halved? contact_modulus is E* with 1/E* = "
    "(1 - nu1^2)/E1 + (1 - nu2^2)/E2 (or a half-width for a full width); scale by the inverse";
constexpr const char* pi_hint = "a factor of pi in the kernel of the integral equation";
constexpr const char* root_hint =
    "distances or half-widths that differ by 2 under a square root: u is the distance from the "
    "edge, c_k the coefficient of u^(k + 1/2)";
constexpr const char* intensity_hint =
    "the stress intensity of fracture mechanics, with its sqrt(2 pi) or sqrt(pi), for the "
    "coefficient of u^(k + 1/2)? scale by the inverse";
constexpr const char* degree_hint = "degrees for radians";
constexpr const char* log_hint =
    "a decimal logarithm for the natural one (or the reverse) in the formula";
constexpr const char* unit_hint = "other units? numbers have the units of the question";
constexpr const char* sign_hint =
    "the other sign convention? p is positive in compression, q towards +x on the body that Q acts "
    "on; change the sign";

constexpr const char* mean_hint = "the mean pressure taken for the greatest? It is pi/4 of that in "
                                  "a line contact, 2/3 in that of a ball";

/// Factors with one cause. A kilogram-force, an inch in mm, a psi in Pa and in kPa are units.
struct NamedFactors {
    std::string_view formulas;
    const char* hint;
    const char* name;
    bool common; ///< more likely than a mistake in the data of a scene
};
constexpr NamedFactors factors_with_names[] = {
    {"1", sign_hint, "sign", true},
    {"2 4", modulus_hint, "factor-2", true},
    {"1/2 1/4", half_hint, "factor-2", true},
    {"pi 1/pi 2*pi 1/(2*pi) pi/2 2/pi", pi_hint, "factor-pi", false},
    {"pi/4 2/3", mean_hint, "mean-for-peak", false},
    {"sqrt(2) 1/sqrt(2) 2*sqrt(2)", root_hint, "factor-sqrt-2", false},
    {"sqrt(pi) 1/sqrt(pi)", intensity_hint, "factor-sqrt-pi", false},
    {"sqrt(2*pi) 1/sqrt(2*pi)", intensity_hint, "factor-sqrt-2-pi", false},
    {"180/pi pi/180", degree_hint, "degrees", false},
    {"log(10) 1/log(10)", log_hint, "log10", false},
    {"9.80665 1/9.80665", unit_hint, "unit-g", false},
    {"25.4 1/25.4", unit_hint, "unit-inch", false},
    {"6894.757293168 1/6894.757293168 6.894757293168 1/6.894757293168", unit_hint, "unit-psi",
     false},
    {"10^1 10^2 10^3 10^4 10^5 10^6 10^9", unit_hint, "power-of-ten", true},
    {"10^-1 10^-2 10^-3 10^-4 10^-5 10^-6 10^-9", unit_hint, "power-of-ten", true},
};

std::string in_words(std::string formula, bool negative) {
    if (formula == "1") {
        return "minus ";
    }
    std::ranges::replace(formula, '*', ' ');
    return (negative ? "-" : "") + formula + " times ";
}

} // namespace

std::vector<NamedFactor> named_factors() {
    std::vector<NamedFactor> list;
    for (const NamedFactors& factors : factors_with_names) {
        for (const std::string_view part : io::split_words(factors.formulas)) {
            const std::string formula(part);
            const Real factor = formula::Exact::parse(formula).to<Real>();
            for (const int sign : {1, -1}) {
                if (formula != "1" || sign < 0) {
                    list.push_back({factor * sign, in_words(formula, sign < 0), factors.hint,
                                    factors.name, factors.common});
                }
            }
        }
    }
    return list;
}

std::vector<NearFactor> near_factors(double least, double most) {
    constexpr double most_rest = 0.105; // that a factor with a name may leave
    // If a factor is named, so are those whose rest, over the limits of a rest, is that much
    // larger.
    constexpr double similar_rest = 1.25;
    const auto off = [](const Real& x, const Real& of) {
        return std::abs(Real(x / of - 1).convert_to<double>());
    };
    const double wide = most - least;
    const auto rest = [&](const Real& k) { return std::max(off(least, k), off(most, k)); };
    const auto of_limits = [&](const NamedFactor& factor) {
        const Real& k = factor.value;
        const bool apart = wide > 0 && (k < least - wide || k > most + wide);
        const double error = std::max(off(k, 1), off(1, k));
        return apart || !is_possible(factor.name, "")
                   ? std::numeric_limits<double>::max()
                   : rest(k) * std::max(1 / most_rest, least_gain / error);
    };
    const std::vector<NamedFactor> factors = named_factors();
    const double nearest = of_limits(*std::ranges::min_element(factors, {}, of_limits));
    std::vector<NearFactor> list;
    for (const NamedFactor& factor : factors) {
        if (nearest <= 1 && of_limits(factor) <= std::max(1.0, similar_rest * nearest)) {
            list.push_back({factor, rest(factor.value)});
        }
    }
    return list;
}

} // namespace edgeproof::diagnose
