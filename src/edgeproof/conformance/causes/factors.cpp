// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/conformance/causes/readings.hpp"
#include "edgeproof/formula/exact/exact.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <ranges>
#include <string_view>
#include <utility>

namespace edgeproof::conformance {
namespace {

using namespace convention_rule;

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
constexpr const char* unit_hint = "other units? numbers have the units of the question";
constexpr const char* other_hint =
    "a constant of proportionality that differs; scale by its inverse";

/// Factors with one cause. A kilogram-force, an inch in mm, a psi in Pa and in kPa are units.
struct NamedFactors {
    std::string_view formulas;
    const char* hint;
    const char* name;
};
constexpr NamedFactors factors_with_names[] = {
    {"1", "", "sign"},
    {"2 4", modulus_hint, "factor-2"},
    {"1/2 1/4", half_hint, "factor-2"},
    {"pi 1/pi 2*pi 1/(2*pi) pi/2 2/pi", pi_hint, "factor-pi"},
    {"sqrt(2) 1/sqrt(2) 2*sqrt(2)", root_hint, "factor-sqrt-2"},
    {"sqrt(pi) 1/sqrt(pi)", intensity_hint, "factor-sqrt-pi"},
    {"sqrt(2*pi) 1/sqrt(2*pi)", intensity_hint, "factor-sqrt-2-pi"},
    {"180/pi pi/180", degree_hint, "degrees"},
    {"9.80665 1/9.80665", unit_hint, "unit-g"},
    {"25.4 1/25.4", unit_hint, "unit-inch"},
    {"6894.757293168 1/6894.757293168 6.894757293168 1/6.894757293168", unit_hint, "unit-psi"},
    {"10^1 10^2 10^3 10^4 10^5 10^6 10^9", unit_hint, "power-of-ten"},
    {"10^-1 10^-2 10^-3 10^-4 10^-5 10^-6 10^-9", unit_hint, "power-of-ten"},
};

std::string in_words(std::string formula, bool negative) {
    if (formula == "1") {
        return negative ? "minus " : "";
    }
    std::ranges::replace(formula, '*', ' ');
    return fmt::format("{}{} times ", negative ? "-" : "", formula);
}

/// The digits that half the rows have without a factor.
double digits_of_half(const std::vector<FailingRow>& rows) {
    std::vector<double> digits;
    for (const FailingRow& row : rows) {
        digits.push_back(digits_between(row.ratio, Real(1)));
    }
    const auto middle = digits.begin() + static_cast<long>(digits.size() / 2);
    std::nth_element(digits.begin(), middle, digits.end());
    return *middle;
}

struct Allowed {
    Real value;
    std::string words;
    const char* hint;
    const char* name;
    double digits; ///< agreement with the median
};
std::vector<Allowed> allowed_by(const Ratios& ratios) {
    std::vector<Allowed> allowed;
    for (const NamedFactors& factors : factors_with_names) {
        for (const auto part : std::views::split(factors.formulas, ' ')) {
            const std::string formula(part.begin(), part.end());
            const Real factor = formula::Exact::parse(formula).to<Real>();
            for (const int sign : {1, -1}) {
                const Real value = factor * sign;
                if ((formula != "1" || sign < 0) && ratios.allow(value)) {
                    allowed.push_back({value, in_words(formula, sign < 0), factors.hint,
                                       factors.name, digits_between(ratios.median(), value)});
                }
            }
        }
    }
    std::ranges::stable_sort(allowed, std::greater(), &Allowed::digits);
    return allowed;
}

} // namespace

std::optional<Convention> infer_factor(const std::string& of, const std::vector<FailingRow>& rows,
                                       bool named) {
    if (rows.size() < least_rows) {
        return {};
    }
    std::vector<Real> straight;
    std::vector<Real> mirrored;
    for (const FailingRow& row : rows) {
        straight.push_back(row.ratio);
        if (row.mirrored) {
            mirrored.push_back(*row.mirrored);
        }
    }
    const double to_gain_on = digits_of_half(rows);
    std::optional<Convention> best;
    const auto take = [&](const Ratios& ratios, const Real& factor, std::string relation,
                          std::string hint, std::string name) {
        const Held held = ratios.held_to(factor);
        const bool better = !best || held.most > best->held + as_good;
        if (better && held.most >= to_gain_on + least_gain && enough(held.rows, rows.size())) {
            best = Convention{of,        std::move(relation), held.worst,
                              held.rows, rows.size(),         std::move(hint),
                              {},        held.most,           std::move(name)};
            best->factor = factor.convert_to<double>();
            return true;
        }
        return false;
    };
    const Ratios same(std::move(straight), rows.size());
    if (!named) {
        if (same.one_number()) {
            take(same, same.median(), same.median_text() + " times ours", other_hint, "factor");
        }
        return best;
    }
    for (const bool swapped : {false, true}) {
        const Ratios ratios = swapped ? Ratios(std::move(mirrored), rows.size()) : same;
        if (!ratios.one_number()) {
            continue;
        }
        const std::string ours = swapped ? "ours at the other edge" : "ours";
        const std::vector<Allowed> allowed = allowed_by(ratios);
        if (allowed.empty()) {
            continue;
        }
        const Allowed& first = allowed.front();
        const std::string hint = swapped ? "left taken for right, and a factor"
                                 : first.words == "minus "
                                     ? "the other sign convention? p is positive in compression, q "
                                       "towards +x on the body that Q acts on; change the sign"
                                     : first.hint;
        if (take(ratios, first.value, first.words + ours, hint,
                 swapped ? "edges-swapped" : first.name)) {
            for (std::size_t i = 1; i < allowed.size(); ++i) {
                best->also.push_back(allowed[i].words + ours);
                best->equally_likely.emplace_back(swapped ? "edges-swapped" : allowed[i].name);
            }
        }
    }
    return best;
}

} // namespace edgeproof::conformance
