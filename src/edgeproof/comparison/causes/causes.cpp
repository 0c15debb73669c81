// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/comparison/causes/causes.hpp"
#include "edgeproof/diagnose/fit.hpp"
#include "edgeproof/roots/bracketed_root.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace edgeproof::comparison {
namespace {

using diagnose::Candidate;

constexpr double right_as_a_mesh = 0.003; ///< of the largest pressure: data that need no cause
constexpr double most_of_a_mesh = 0.03;   ///< the largest allowance for a mesh's own error
constexpr double roundoff = 1e-12;
constexpr std::size_t most_nodes = 1000;
constexpr std::size_t fewest_nodes_counted = 8;
constexpr double edge_share = 0.02; ///< relative to the suspect's contact
constexpr double least_unit = 0.1;  ///< relative to the largest value
constexpr double share_of_one_sign = 0.9;
constexpr double share_left = 0.3; ///< of the error, that a cause may leave

/// Values of the data that are diagnosed, and the exact ones.
struct Observed {
    UsedNodes nodes;
    std::vector<double> values;
    Suspect right;
    double element = 0;          ///< the widest at an edge
    std::vector<double> corners; ///< where p is infinite

    /// False at nodes within two elements, or a fiftieth of the suspect's contact, of one of its
    /// edges or of a corner.
    [[nodiscard]] bool counts(const Suspect& suspect, std::size_t i) const {
        const double zone = std::max(2 * element, edge_share * (suspect.a + suspect.b));
        const double x = nodes[i].x;
        return std::isfinite(suspect.values[i]) && std::isfinite(right.values[i]) &&
               std::min(std::abs(x - suspect.a), std::abs(x + suspect.b)) >= zone &&
               std::ranges::none_of(corners, [=](double at) { return std::abs(x - at) < zone; });
    }
    [[nodiscard]] bool inside(const Suspect& suspect, std::size_t i) const {
        return counts(suspect, i) && nodes[i].x < suspect.a && nodes[i].x > -suspect.b;
    }
    /// The data over the exact values of the nodes.
    [[nodiscard]] std::vector<double> ratios() const {
        std::vector<double> list;
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (std::isfinite(right.values[i]) && right.values[i] != 0) {
                list.push_back(values[i] / right.values[i]);
            }
        }
        return list;
    }
    /// Every node of one parity, or without it every second of the means over three neighbours with
    /// weights 1/4, 1/2 and 1/4.
    [[nodiscard]] Observed part(std::optional<std::size_t> parity) const {
        Observed part{{nodes.data, {}}, {}, right, element * (parity ? 1 : 2), corners};
        part.right.values.clear();
        const std::size_t end = nodes.size() - (parity ? 0 : 1);
        for (std::size_t i = parity.value_or(1); i < end; i += 2) {
            const auto at = [&](const std::vector<double>& v) {
                return parity ? v[i] : (v[i - 1] + 2 * v[i] + v[i + 1]) / 4;
            };
            part.nodes.nodes.push_back(nodes.nodes[i]);
            part.values.push_back(at(values));
            part.right.values.push_back(at(right.values));
        }
        return part;
    }
    /// A suspect on the contact -b < x < a with the pressures p(x).
    template <class Pressure>
    [[nodiscard]] Suspect suspect(const char* name, double a, double b, const Pressure& p) const {
        Suspect s{name, "", a, b, {}};
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            s.values.push_back(p(nodes[i].x).value_or(std::nan("")));
        }
        return s;
    }
};

/// The errors that a suspect leaves.
struct Left {
    /// Relative to the value of the node, or to a tenth of the largest one.
    diagnose::Remainders rows;
    double rms = 0;    ///< relative to the largest value
    double inside = 0; ///< the same, over the nodes in the suspect's contact
    double noise = 0;  ///< the rms scatter from node to node, relative to it
    Worst worst = Worst::near_edge;
};

/// All nodes, or some at equal steps if there are many.
Observed observed_in(const AlignedResult& data, const DataContact& contact,
                     const ExactContact& exact, TractionOf of) {
    Observed observed{{data, {}},
                      {},
                      {"", "", exact.a().value, exact.b().value, {}},
                      std::max(contact.element[0], contact.element[1]),
                      {}};
    const std::size_t step = (data.nodes.size() + most_nodes - 1) / most_nodes;
    for (std::size_t i = 0; i < data.nodes.size(); i += std::max<std::size_t>(1, step)) {
        const Traction* const t = of(data.nodes[i]);
        observed.nodes.nodes.push_back(i);
        observed.values.push_back(t != nullptr ? t->data : 0);
        observed.right.values.push_back(t != nullptr ? t->exact.value_or(std::nan(""))
                                                     : std::nan(""));
    }
    for (const ContactKnot& knot : exact.knots()) {
        if (knot.corner) {
            observed.corners.push_back(knot.x);
        }
    }
    return observed;
}

/// Returns nothing if fewer than eight nodes lie inside the suspect's contact.
std::optional<Left> left_by(const Observed& data, const Suspect& suspect) {
    double products = 0;
    double largest = 0;
    double largest_right = 0;
    for (std::size_t i = 0; i < data.nodes.size(); ++i) {
        if (data.counts(suspect, i)) {
            products += data.values[i] * suspect.values[i];
            largest = std::max(largest, std::abs(suspect.values[i]));
            largest_right = std::max(largest_right, std::abs(data.right.values[i]));
        }
    }
    const double sign = products < 0 ? -1 : 1; // a mistake may make the pressure mainly tensile
    Left left;
    double square = 0;
    double square_inside = 0;
    double second = 0;
    std::size_t all = 0;
    std::size_t inside = 0;
    std::size_t seconds = 0;
    std::pair worst{0.0, Worst::near_edge};
    std::array<std::optional<double>, 3> last; // errors of three nodes in turn
    std::optional<std::size_t> neighbour;
    for (std::size_t i = 0; i < data.nodes.size(); ++i) {
        const double value = suspect.values[i];
        const double number = sign * data.values[i];
        const bool counts = data.counts(suspect, i);
        const bool within = data.inside(suspect, i);
        if (std::isfinite(value)) {
            worst = std::max(worst, {std::abs(number - value), within   ? Worst::inside
                                                               : counts ? Worst::outside
                                                                        : Worst::near_edge});
        }
        const double off = (number - value) / largest;
        last = {last[1], last[2], within ? std::optional(off) : std::nullopt};
        if (last[0] && last[1] && last[2]) {
            second += std::pow(*last[0] - 2 * *last[1] + *last[2], 2) / 6;
            ++seconds;
        }
        all += counts ? 1 : 0;
        inside += within ? 1 : 0;
        square += counts ? off * off : 0;
        square_inside += within ? off * off : 0;
        if (!counts || (value == 0 && number == 0)) {
            neighbour.reset();
            continue;
        }
        const double right = data.right.values[i];
        const double unit = std::max(std::abs(value), least_unit * largest);
        const double unit_of_right = std::max(std::abs(right), least_unit * largest_right);
        left.rows.off.push_back((number - value) / unit);
        left.rows.before.push_back(std::abs(data.values[i] - right) / unit_of_right);
        left.rows.ratio.push_back(std::max(left.rows.before.back(),
                                           std::abs(data.values[i] - right) /
                                               std::max(std::abs(number), least_unit * largest)));
        left.rows.change.push_back(std::abs(sign * value - right) / unit_of_right);
        const std::size_t here = left.rows.off.size() - 1;
        if (neighbour && within) {
            left.rows.neighbours.emplace_back(*neighbour, here);
        }
        neighbour = within ? std::optional(here) : std::nullopt;
    }
    if (!(largest > 0) || inside < fewest_nodes_counted) {
        return {};
    }
    left.rms = std::sqrt(square / static_cast<double>(all));
    left.inside = std::sqrt(square_inside / static_cast<double>(inside));
    left.worst = worst.second;
    left.noise = seconds > 0 ? std::sqrt(second / static_cast<double>(seconds)) : 0;
    return left;
}

/// True if the part of the error that changes its sign from node to node has one sign at nearly all
/// nodes of the contact, if every second sign is reversed. That part of noise has no constant sign,
/// and that of a wave k elements long changes it after k/(k - 2) nodes.
bool has_one_sign(const Observed& data) {
    const auto error = [&](std::size_t i) { return data.values[i] - data.right.values[i]; };
    std::size_t all = 0;
    std::size_t positive = 0;
    for (std::size_t i = 1; i + 1 < data.nodes.size(); ++i) {
        if (data.inside(data.right, i - 1) && data.inside(data.right, i) &&
            data.inside(data.right, i + 1)) {
            const double part = 2 * error(i) - error(i - 1) - error(i + 1);
            positive += (part > 0) == (i % 2 == 0) ? 1 : 0;
            ++all;
        }
    }
    return static_cast<double>(std::max(positive, all - positive)) >=
           share_of_one_sign * static_cast<double>(all);
}

/// Recognises data that alternate from node to node, as those at the corners and in the middles of
/// the sides of quadratic elements do: every second node is right, or the means over neighbours
/// are. `unexplained`: the error of all nodes.
std::optional<Cause> alternation(const Observed& data, double allowance, double unexplained) {
    if (data.nodes.size() != data.nodes.data.nodes.size() || !has_one_sign(data)) {
        return {}; // if only some nodes are used, they are not neighbours
    }
    for (const std::optional<std::size_t> parity : {std::optional<std::size_t>(0), {1}, {}}) {
        const Observed part = data.part(parity);
        const auto left = left_by(part, part.right);
        if (!left || !is_noise(remainder_of(left->rows), allowance) ||
            left->rms > share_left * unexplained) {
            continue;
        }
        std::string what =
            "p alternates about the right one from node to node: corners and middles of the sides "
            "of quadratic elements; give means over neighbours";
        if (parity) {
            const double off = diagnose::sorted_at(data.part(1 - *parity).ratios(), 0.5) - 1;
            what = fmt::format("every second node is right, and the others are {:.3g} % too {} in "
                               "the median: corners and middles of the sides of quadratic elements",
                               100 * std::abs(off), off < 0 ? "small" : "large");
        }
        return Cause{"mid-side-nodes", std::move(what), 1, left->rms, {}};
    }
    return {};
}

double median_of(std::vector<double> list) {
    return list.empty() ? 1 : diagnose::sorted_at(std::move(list), 0.5);
}

/// The mesh's own error that is allowed, and the error to be explained.
struct Unexplained {
    double allowance = 0;
    double size = 0; ///< the root mean square
};

/// True if what a suspect leaves is a part of the error, in the mean over all nodes, too: a fit is
/// judged by the nodes that the suspect changes.
bool leaves_little(const Left& left, const Unexplained& error) {
    return left.rms < share_left * error.size;
}

/// What a suspect leaves, if it explains the data.
std::optional<Left> explained_by(const Observed& data, const Suspect& suspect,
                                 const Unexplained& error) {
    auto left = left_by(data, suspect);
    return left && leaves_little(*left, error) && fit_of(left->rows, 0, error.allowance)
               ? left
               : std::nullopt;
}

/// The causes that the data do not distinguish, the most likely first.
std::vector<Cause> causes_among(const std::vector<Suspect>& suspects, const Observed& data,
                                const Unexplained& error) {
    std::vector<Candidate> likely;
    std::vector<Candidate> others;
    std::vector<double> rms(suspects.size());
    for (std::size_t i = 0; i < suspects.size(); ++i) {
        const auto left = left_by(data, suspects[i]);
        if (!left) {
            continue;
        }
        rms[i] = left->rms;
        Candidate candidate{suspects[i].name, suspects[i].what, "", 1, Candidate::mistake, i};
        auto fit = leaves_little(*left, error) ? fit_of(left->rows, 0, error.allowance)
                                               : std::optional<diagnose::Fit>();
        candidate.fit = fit ? std::move(*fit) : remainder_of(left->rows);
        (fit ? likely : others).push_back(std::move(candidate));
    }
    if (likely.empty()) {
        return {};
    }
    double noise = error.allowance / 3;
    const double unit = unit_of(likely, noise);
    const double most = most_misfit(likely, unit, likely.front().fit.off.size(),
                                    [](const Candidate& c) { return c.fit; });
    std::ranges::copy_if(others, std::back_inserter(likely),
                         [&](const Candidate& c) { return misfit(c.fit, unit) <= most; });
    keep_best(likely, noise);
    // Mistakes of the same effect stay in the order of the catalogue.
    std::ranges::sort(likely, {}, [&](const Candidate& c) {
        return std::pair(std::round(rms[*c.source] / roundoff), *c.source);
    });
    const double factor = median_of(data.ratios());
    std::vector<Cause> causes;
    std::vector<std::string> names;
    for (const Candidate& one : likely) {
        const bool known = std::ranges::any_of(causes, [&](const Cause& other) {
            return other.name == one.name && other.what == one.what;
        });
        if (!known) {
            causes.push_back({one.name, one.what, factor, rms[*one.source], {}});
        }
        if (std::ranges::find(names, one.name) == names.end()) {
            names.push_back(one.name);
        }
    }
    for (Cause& cause : causes) {
        std::ranges::remove_copy(names, std::back_inserter(cause.equally_likely), cause.name);
    }
    return causes;
}

/// The ratio of the data to the exact values, if it explains the data as a cause would.
std::optional<CommonFactor> common_factor(const Observed& data, const Unexplained& error,
                                          double& noise) {
    std::vector<double> ratios = data.ratios();
    std::erase_if(ratios, [](double ratio) { return ratio == 0; });
    const double factor = median_of(ratios);
    Suspect scaled = data.right;
    for (double& value : scaled.values) {
        value *= factor;
    }
    const auto left = explained_by(data, scaled, error);
    if (!left) {
        return {};
    }
    noise = left->noise;
    for (double& ratio : ratios) {
        ratio = std::abs(ratio / factor - 1);
    }
    return CommonFactor{factor, diagnose::error_of_median(std::move(ratios)) * std::abs(factor)};
}

/// The factor of x, if the exact pressure at x over it explains the data. Its error follows from
/// the scatter of the nodes and the slopes of p.
std::optional<CommonFactor> stretch_of(const Observed& data, const ExactContact& exact,
                                       const Unexplained& unexplained, double& noise) {
    constexpr double most = 2;
    constexpr int steps = 40;
    constexpr double small = 1e-4;
    const auto stretched = [&](double k) {
        return data.suspect("", k * exact.a().value, k * exact.b().value,
                            [&](double x) { return exact.quick_pressure(x / k); });
    };
    const auto error = [&](double logarithm) {
        const auto left = left_by(data, stretched(std::exp(logarithm)));
        return left ? left->rms : std::numeric_limits<double>::infinity();
    };
    const double k =
        std::exp(roots::place_of_minimum(error, -std::log(most), std::log(most), steps));
    const auto left = explained_by(data, stretched(k), unexplained);
    if (!left) {
        return {};
    }
    const Suspect wider = stretched(k * (1 + small));
    const Suspect narrower = stretched(k * (1 - small));
    double squares = 0;
    for (std::size_t i = 0; i < data.nodes.size(); ++i) {
        const double slope = (wider.values[i] - narrower.values[i]) / (2 * small);
        squares += data.inside(narrower, i) ? slope * slope : 0;
    }
    noise = left->noise;
    return CommonFactor{k, k * noise * exact.scale().value / std::sqrt(squares), true};
}

/// Noise of some percent needs the floor: the scatter of a few hundred nodes is not known better.
double allowance_for(double mesh_error, double unexplained) {
    constexpr double share_of_error = 0.05; // of the error to be explained
    return std::max(std::min(mesh_error, most_of_a_mesh),
                    std::min(right_as_a_mesh, share_of_error * unexplained));
}

Diagnosis diagnose_observed(const Observed& data, const std::vector<Suspect>& suspects,
                            double mesh_error) {
    Diagnosis diagnosis;
    const auto as_it_is = left_by(data, data.right); // empty if hardly any node is in the contact
    diagnosis.unexplained = as_it_is ? as_it_is->rms : 1;
    diagnosis.too_few = !as_it_is;
    if (as_it_is) {
        diagnosis.noise = as_it_is->noise;
        diagnosis.inside = as_it_is->inside;
        diagnosis.worst = as_it_is->worst;
        diagnosis.at_edges_only =
            is_noise(remainder_of(as_it_is->rows),
                     std::max(right_as_a_mesh, std::min(mesh_error, most_of_a_mesh)));
    }
    const Unexplained error{allowance_for(mesh_error, diagnosis.unexplained),
                            diagnosis.unexplained};
    diagnosis.causes = causes_among(suspects, data, error);
    if (diagnosis.causes.empty() && as_it_is) {
        if (auto cause = alternation(data, error.allowance, error.size)) {
            diagnosis.causes.push_back(std::move(*cause));
        }
    }
    if (!diagnosis.causes.empty()) {
        diagnosis.noise = diagnosis.causes.front().scatter;
    } else if (as_it_is && !diagnosis.at_edges_only) {
        diagnosis.factor = common_factor(data, error, diagnosis.noise);
    }
    return diagnosis;
}

/// The scene under the force that the data carry. The rule for it is applied to its exact pressure,
/// too, to correct the error of the rule.
std::optional<Cause> own_force(const Observed& data, double force, SuspectContacts& suspects,
                               const Unexplained& error) {
    const ExactContact* contact = nullptr;
    const auto solve = [&](double P) {
        contact = suspects.with(fmt::format("P = {:.17g}", P), [P](scene::Scene& other) {
            other = other.without_shear();
            scene::change_given(other, [P](scene::Scene& given) {
                given.load =
                    contact::Load::force(formula::Exact(formula::Expr::number(exact_rational(P))));
            });
        });
    };
    if (!(force > 0 && std::isfinite(force))) {
        return {};
    }
    solve(force);
    if (contact != nullptr) {
        const auto exact = [&](const Node& node) { return contact->quick_pressure(node.x); };
        const double corrected = force * force / force_of(data.nodes.data, *contact, exact);
        force = corrected > 0 && corrected < 2 * force ? corrected : force;
        solve(force);
    }
    if (contact == nullptr) {
        return {};
    }
    const Suspect carried = data.suspect("another-force", contact->a().value, contact->b().value,
                                         [&](double x) { return contact->quick_pressure(x); });
    const auto left = explained_by(data, carried, error);
    if (!left) {
        return {};
    }
    Observed by_carried = data;
    by_carried.right = carried;
    return Cause{
        carried.name,
        fmt::format("the data carry P = {:.5g}; with that force they agree to {:.2g} %: "
                    "another load step{}?",
                    force, 100 * left->rms,
                    contact->axisymmetric() ? "" : ", or a total force for a force per length"),
        median_of(by_carried.ratios()),
        left->rms,
        {}};
}

constexpr int most_rounded_digits = 9;
constexpr double half_unit = 0.51; ///< of the last digit, with a little for binary64
constexpr double near_edge_share = 0.02;
constexpr double units_of_binary32 = 16;
/// Rounding errors are uniformly distributed, with an rms of 1/sqrt(3) of the largest; the data's
/// own noise, which is smaller, adds to them.
constexpr double rms_with_noise = 0.65;
constexpr double largest_with_noise = 2;

/// True if rounding by `allowed` at each node explains all errors that count, those of pressures
/// outside the contact, too.
template <class Allowed>
bool rounding_explains(const AlignedResult& data, const ExactContact& exact,
                       const Allowed& allowed) {
    double largest = 0;
    double squares = 0;
    std::size_t n = 0;
    for (const Node& node : data.nodes) {
        if (node.p.exact && std::abs(node.place.u()) > near_edge_share * exact.length()) {
            const double part = std::abs(node.p.error) / std::max(allowed(node), node.p.rounding);
            largest = std::max(largest, part);
            squares += part * part;
            ++n;
        }
    }
    return largest <= 1 || (largest <= largest_with_noise &&
                            squares <= rms_with_noise * rms_with_noise * static_cast<double>(n));
}

/// Finds pressures that carry fewer digits than are written: rounded to a number of significant
/// digits or decimals, or numbers of binary32; accepted if the errors away from the edges (by a
/// fiftieth of the contact, on either side) are no larger than this rounding explains. For
/// binary32, 16 units in the last place of the largest pressure are allowed for a computation.
std::optional<Cause> cause_in_digits(const ResultTable& table, const AlignedResult& data,
                                     const ExactContact& exact) {
    const CarriedDigits& digits = table.p_digits;
    const double factor = table.p_factor;
    const auto significant_unit = [&](const Node& node) {
        const double p = std::abs(node.p.data / factor);
        const double leading = p > 0 ? std::floor(std::log10(p * (1 + 1e-15))) : -300;
        return half_unit * factor * std::pow(10.0, leading - digits.significant + 1);
    };
    const auto decimal_unit = [&](const Node&) {
        return half_unit * factor * std::pow(10.0, -digits.decimals);
    };
    const bool few = digits.significant <= most_rounded_digits;
    if (few && rounding_explains(data, exact, significant_unit)) {
        return Cause{fmt::format("rounded-to-{}", digits.significant),
                     fmt::format("p is rounded to {} digits", digits.significant)};
    }
    if (few && !digits.exponents && rounding_explains(data, exact, decimal_unit)) {
        return Cause{fmt::format("rounded-to-{}-decimals", digits.decimals),
                     fmt::format("p is rounded to {} decimals", digits.decimals)};
    }
    const double single = units_of_binary32 * std::ldexp(exact.scale().value, -24);
    if (digits.binary32 &&
        rounding_explains(data, exact, [single](const Node&) { return single; })) {
        return Cause{"binary32", "p consists of binary32 numbers, about 7 digits"};
    }
    return {};
}

} // namespace

Diagnosis diagnose_pressure(const ResultTable& table, const AlignedResult& data,
                            const DataContact& contact, SuspectContacts& suspects,
                            const ExactContact& exact, double mesh_error) {
    const Observed observed = observed_in(data, contact, exact, p_of);
    Diagnosis diagnosis =
        diagnose_observed(observed, pressure_suspects(observed.nodes, suspects, exact), mesh_error);
    if (diagnosis.causes.empty() && !diagnosis.at_edges_only) {
        const Unexplained error{allowance_for(mesh_error, diagnosis.unexplained),
                                diagnosis.unexplained};
        if (auto cause = own_force(observed, contact.force.value_or(0), suspects, error)) {
            diagnosis.causes.push_back(std::move(*cause));
            diagnosis.factor.reset();
        } else if (!diagnosis.factor && !diagnosis.too_few) {
            diagnosis.factor = stretch_of(observed, exact, error, diagnosis.noise);
        }
    }
    if (diagnosis.at_edges_only && diagnosis.causes.empty()) {
        if (const auto cause = cause_in_digits(table, data, exact)) {
            diagnosis.causes.push_back(*cause);
        }
    }
    return diagnosis;
}

Diagnosis diagnose_shear(const AlignedResult& data, const DataContact& contact,
                         SuspectContacts& suspects, const ExactContact& exact, double mesh_error) {
    const Observed observed = observed_in(data, contact, exact, q_of);
    return diagnose_observed(observed, shear_suspects(observed.nodes, suspects, exact), mesh_error);
}

} // namespace edgeproof::comparison
