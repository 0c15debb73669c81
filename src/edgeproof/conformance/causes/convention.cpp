// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/conformance/causes/convention.hpp"

#include "edgeproof/conformance/causes/convention_rule.hpp"
#include "edgeproof/conformance/causes/unit_mistake.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace edgeproof::conformance {
namespace {

using namespace convention_rule;

/// times/over, and pi or the root of 2 to a power.
struct Factor {
    const char* text;
    int times;
    int over;
    int pi;
    int root;
    const char* hint;
};

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
constexpr const char* degree_hint = "degrees for radians";
constexpr const char* other_hint =
    "a constant of proportionality that differs; scale by its inverse";

const std::vector<Factor>& all_factors() {
    static const std::vector<Factor> factors{
        {"1", 1, 1, 0, 0, ""},
        {"2", 2, 1, 0, 0, modulus_hint},
        {"1/2", 1, 2, 0, 0, half_hint},
        {"4", 4, 1, 0, 0, modulus_hint},
        {"1/4", 1, 4, 0, 0, half_hint},
        {"pi", 1, 1, 1, 0, pi_hint},
        {"1/pi", 1, 1, -1, 0, pi_hint},
        {"2 pi", 2, 1, 1, 0, pi_hint},
        {"1/(2 pi)", 1, 2, -1, 0, pi_hint},
        {"pi/2", 1, 2, 1, 0, pi_hint},
        {"2/pi", 2, 1, -1, 0, pi_hint},
        {"sqrt(2)", 1, 1, 0, 1, root_hint},
        {"1/sqrt(2)", 1, 1, 0, -1, root_hint},
        {"2 sqrt(2)", 2, 1, 0, 1, root_hint},
        {"180/pi", 180, 1, -1, 0, degree_hint},
        {"pi/180", 1, 180, 1, 0, degree_hint},
    };
    return factors;
}

/// A failing row: the answer over the reference, and over what stands at the other edge.
struct FailingRow {
    std::size_t question;
    Real ratio;
    std::optional<Real> mirrored;
};

Real value_of(const Factor& factor) {
    const Real pi = 4 * atan(Real(1));
    const Real root = sqrt(Real(2));
    return Real(factor.times) / factor.over * pow(pi, factor.pi) * pow(root, factor.root);
}

struct Fit {
    std::size_t rows = 0;
    double digits = 0;
};

template <class RatioOf>
std::optional<Fit> fit(const std::vector<FailingRow>& rows, const Real& factor,
                       const RatioOf& ratio_of) {
    Fit result{0, most_digits};
    for (const FailingRow& row : rows) {
        const std::optional<Real> ratio = ratio_of(row);
        const double digits = ratio ? digits_between(*ratio, factor) : 0;
        if (digits >= least_digits) {
            ++result.rows;
            result.digits = std::min(result.digits, digits);
        }
    }
    return enough(result.rows, rows.size()) ? std::optional(result) : std::nullopt;
}

/// `named`: by a factor that has a meaning; else by any.
std::optional<Convention> explain(const std::string& of, const std::vector<FailingRow>& rows,
                                  bool named) {
    if (rows.size() < least_rows) {
        return {};
    }
    const auto straight = [](const FailingRow& row) { return std::optional(row.ratio); };
    const auto swapped = [](const FailingRow& row) { return row.mirrored; };
    const auto say = [&](const Fit& f, std::string relation, std::string hint) {
        return Convention{of, std::move(relation), f.digits, f.rows, rows.size(), std::move(hint)};
    };
    for (const Factor& factor : named ? all_factors() : std::vector<Factor>{}) {
        for (const int sign : {1, -1}) {
            const Real value = value_of(factor) * sign;
            const bool unit = std::string_view(factor.text) == "1";
            const std::string times =
                unit ? (sign > 0 ? "" : "minus ")
                     : fmt::format("{}{} times ", sign > 0 ? "" : "-", factor.text);
            if (const auto f = unit && sign > 0 ? std::nullopt : fit(rows, value, straight)) {
                const std::string hint =
                    unit ? "the other sign convention? p is positive in compression, q towards +x "
                           "on the body that Q acts on; change the sign"
                         : factor.hint;
                return say(*f, times + "ours", hint);
            }
            if (const auto f = fit(rows, value, swapped)) {
                return say(*f, times + "ours at the other edge",
                           "left taken for right? u runs inwards from the edge: u = a - x at the "
                           "right one, u = b + x at the left one; swap the edges");
            }
        }
    }
    if (named) {
        return {};
    }
    std::vector<Real> ratios;
    ratios.reserve(rows.size());
    for (const FailingRow& row : rows) {
        ratios.push_back(row.ratio);
    }
    std::nth_element(ratios.begin(), ratios.begin() + static_cast<long>(ratios.size() / 2),
                     ratios.end());
    const Real median = ratios[ratios.size() / 2];
    // The rows must not be told apart from the reference by so little that any factor fits.
    if (median == 0 || digits_between(median, Real(1)) >= least_digits) {
        return {};
    }
    if (const auto f = fit(rows, median, straight)) {
        return say(*f, fmt::format("{:.10g} times ours", median.convert_to<double>()), other_hint);
    }
    return {};
}

/// The references of the failing rows, at the other edge; nothing where one has none.
std::map<std::size_t, Ball> mirrored_references(const Answers& answers,
                                                const std::vector<std::size_t>& failing,
                                                ReferenceOptions options) {
    Questions mirrored;
    mirrored.file = answers.questions.file;
    mirrored.contacts = answers.questions.contacts;
    std::vector<std::size_t> of;
    for (const std::size_t i : failing) {
        Question q = answers.questions.list[i];
        if (q.at_edge() && !mirrored.contacts[q.contact].scene.symmetric()) {
            q.edge = opposite(q.edge);
            mirrored.list.push_back(std::move(q));
            of.push_back(i);
        }
    }
    options.digits = {most_digits, Rounding::nearest, false};
    std::map<std::size_t, Ball> balls;
    const auto values = references_where_any(mirrored, options);
    for (std::size_t k = 0; k < of.size(); ++k) {
        if (values[k]) { // else a corner, seen from the other edge
            balls.emplace(of[k], values[k]->value.value);
        }
    }
    return balls;
}

} // namespace

std::vector<Convention> infer_conventions(const Answers& answers, const Agreements& agreements,
                                          const ReferenceOptions& options) {
    const PrecisionScope scope(most_digits + 20);
    std::vector<std::size_t> failing;
    for (std::size_t i = 0; i < agreements.cases.size(); ++i) {
        const bool number = answers.given[i].state == Answer::State::number;
        if (number && agreements.cases[i].no_reference.empty() &&
            agreements.cases[i].digits < least_digits &&
            !contains_zero(agreements.references[i].value.value)) {
            failing.push_back(i);
        }
    }
    std::vector<Convention> found = infer_precision_loss(answers, agreements);
    if (failing.size() < least_rows) {
        return found;
    }
    const auto mirrored = mirrored_references(answers, failing, options);
    // Each failing row belongs to its quantity (c_k and s_k together, and each), at both edges and
    // at its own.
    std::vector<std::pair<std::string, std::vector<FailingRow>>> groups;
    const auto group = [&](const std::string& name) -> std::vector<FailingRow>& {
        for (auto& [known, rows] : groups) {
            if (known == name) {
                return rows;
            }
        }
        return groups.emplace_back(name, std::vector<FailingRow>{}).second;
    };
    for (const std::size_t i : failing) {
        const Question& q = answers.questions.list[i];
        const Real value = Ball(answers.given[i].value, 256).midpoint();
        FailingRow row{i, value / agreements.references[i].value.value.midpoint(), {}};
        const auto other = mirrored.find(i);
        if (other != mirrored.end() && !contains_zero(other->second)) {
            row.mirrored = value / other->second.midpoint();
        }
        const std::string name = symbol_of(q);
        const std::string family = family_of(q);
        group(family).push_back(row);
        if (q.at_edge()) {
            group(family + ", " + scene::edge_name(q.edge) + " edge").push_back(row);
        }
        if (family != name) {
            group(name).push_back(row);
        }
    }
    // The widest first; of the same rows, the name that says most of them.
    std::stable_sort(groups.begin(), groups.end(), [](const auto& x, const auto& y) {
        const auto says = [](const std::string& name) {
            return name.size() + (name.ends_with("_k") ? 0 : 1);
        };
        return x.second.size() != y.second.size() ? x.second.size() > y.second.size()
                                                  : says(x.first) > says(y.first);
    });
    std::set<std::size_t> explained;
    const auto look = [&](bool named) {
        for (const auto& [name, rows] : groups) {
            const bool known = std::all_of(rows.begin(), rows.end(), [&](const FailingRow& row) {
                return explained.contains(row.question);
            });
            if (const auto convention = known ? std::nullopt : explain(name, rows, named)) {
                found.push_back(*convention);
                for (const FailingRow& row : rows) {
                    explained.insert(row.question);
                }
            }
        }
    };
    look(true);
    std::erase_if(failing, [&](std::size_t i) { return explained.contains(i); });
    for (Convention& reading : infer_unit_mistakes(answers, agreements, failing, options)) {
        for (const std::size_t i : failing) {
            if (family_of(answers.questions.list[i]) == reading.of) {
                explained.insert(i);
            }
        }
        found.push_back(std::move(reading));
    }
    look(false);
    return found;
}

} // namespace edgeproof::conformance
