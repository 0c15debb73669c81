// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/diagnose/factors.hpp"

#include "edgeproof/diagnose/fit.hpp"
#include "edgeproof/formula/exact/exact.hpp"
#include "edgeproof/io/toml/toml_text.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace edgeproof::diagnose {
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
