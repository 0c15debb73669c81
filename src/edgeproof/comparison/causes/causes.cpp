// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/comparison/causes/causes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace edgeproof::comparison {
namespace {

constexpr double right_as_a_mesh = 0.003; ///< of the largest pressure: data that need no cause
constexpr double share_of_error = 0.05;   ///< the least allowance, of the error to be explained
constexpr double most_of_a_mesh = 0.03;   ///< the largest allowance for a mesh's own error
constexpr double scatter_allowance = 1.6;
constexpr double usual_errors = 3; ///< standard errors of the scale of a cause
constexpr double most_errors = 5;  ///< of one that is not excluded
constexpr double share_left = 0.3;
constexpr double as_little = 1.2;
constexpr std::size_t fewest_nodes_counted = 8;
constexpr std::size_t most_nodes = 1000;
constexpr double edge_share = 0.02; ///< relative to the suspect's contact
constexpr double roundoff = 1e-12;

struct Fit {
    double left = 0;        ///< rms of data minus suspect, relative to its largest value
    double noise = 0;       ///< rms scatter of that difference from node to node
    double scale = 1;       ///< the factor of the suspect's values that fits the data best
    double scale_error = 0; ///< its standard error from the local scatter
    std::size_t nodes = 0;
    bool largest_counted = false; ///< the largest of all errors is at a node that counts

    [[nodiscard]] bool is_scatter(double allowance, double standard_errors = usual_errors) const {
        return left <= scatter_allowance * noise + allowance &&
               std::abs(scale - 1) <= standard_errors * scale_error + allowance;
    }
};

/// The remaining error at a node, and the suspect's value there, relative to the largest value.
struct LeftOver {
    double off = 0;
    double value = 0;
};

/// The scatter of the remaining error, and the resulting standard error of the scale. White noise
/// has second differences of sqrt(6) times its size. Only consecutive nodes are used. Noise may be
/// constant or proportional to the pressure: the larger error of the two is taken.
void find_scatter(const std::vector<std::optional<LeftOver>>& left, Fit& fit) {
    double sum = 0;
    double weighted = 0;
    double squares = 0;
    std::size_t n = 0;
    for (std::size_t i = 1; i + 1 < left.size(); ++i) {
        if (left[i - 1] && left[i] && left[i + 1]) {
            const double second = left[i - 1]->off - 2 * left[i]->off + left[i + 1]->off;
            const double square = left[i]->value * left[i]->value;
            sum += second * second / 6;
            weighted += square * second * second / 6;
            squares += square;
            ++n;
        }
    }
    if (n > 0 && squares > 0) {
        fit.noise = std::sqrt(sum / static_cast<double>(n));
        fit.scale_error = std::max(fit.noise / std::sqrt(squares), std::sqrt(weighted) / squares);
    }
}

struct Observed {
    UsedNodes nodes;
    std::vector<double> values;
    double element = 0;          ///< the widest at an edge
    std::vector<double> corners; ///< where p is infinite
};

std::optional<Fit> fit_of(const Observed& data, const Suspect& suspect) {
    const double zone = std::max(2 * data.element, edge_share * (suspect.a + suspect.b));
    const auto counts = [&](std::size_t i) {
        const double x = data.nodes[i].x;
        return std::isfinite(suspect.values[i]) &&
               std::min(std::abs(x - suspect.a), std::abs(x + suspect.b)) >= zone &&
               std::ranges::none_of(data.corners,
                                    [=](double at) { return std::abs(x - at) < zone; });
    };
    Fit fit;
    double largest = 0;
    double products = 0;
    double squares = 0;
    for (std::size_t i = 0; i < data.nodes.size(); ++i) {
        if (counts(i)) {
            largest = std::max(largest, std::abs(suspect.values[i]));
            products += data.values[i] * suspect.values[i];
            squares += suspect.values[i] * suspect.values[i];
        }
    }
    if (!(squares > 0)) {
        return {};
    }
    // The sign of the data is free: a mistake may make the pressure mainly tensile.
    const double sign = products < 0 ? -1 : 1;
    std::vector<std::optional<LeftOver>> left; // of nodes inside the suspect's contact
    double square = 0;
    std::size_t all = 0;
    std::array<double, 2> worst{}; // of nodes near an edge, and of those that count
    for (std::size_t i = 0; i < data.nodes.size(); ++i) {
        const double x = data.nodes[i].x;
        const bool within = counts(i) && x < suspect.a && x > -suspect.b;
        const double off = counts(i) ? (sign * data.values[i] - suspect.values[i]) / largest : 0;
        if (std::isfinite(suspect.values[i])) {
            double& most = worst[counts(i) ? 1 : 0];
            most = std::max(most, std::abs(sign * data.values[i] - suspect.values[i]));
        }
        left.push_back(within ? std::optional(LeftOver{off, suspect.values[i] / largest})
                              : std::nullopt);
        all += counts(i) ? 1 : 0;
        fit.nodes += within ? 1 : 0;
        square += off * off;
    }
    if (fit.nodes < fewest_nodes_counted) {
        return {};
    }
    fit.left = std::sqrt(square / static_cast<double>(all));
    find_scatter(left, fit);
    fit.scale = sign * products / squares;
    fit.largest_counted = worst[1] >= worst[0];
    return fit;
}

Observed observed_in(const AlignedResult& data, const DataContact& contact,
                     const ExactContact& exact) {
    Observed observed{{data, {}}, {}, std::max(contact.element[0], contact.element[1]), {}};
    const std::size_t step = (data.nodes.size() + most_nodes - 1) / most_nodes;
    for (std::size_t i = 0; i < data.nodes.size(); i += std::max<std::size_t>(1, step)) {
        observed.nodes.nodes.push_back(i);
    }
    for (const ContactKnot& knot : exact.knots()) {
        if (knot.corner) {
            observed.corners.push_back(knot.x);
        }
    }
    return observed;
}

double median_ratio(const Observed& data, const std::vector<double>& right) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < right.size(); ++i) {
        if (std::isfinite(right[i]) && right[i] != 0) {
            ratios.push_back(data.values[i] / right[i]);
        }
    }
    if (ratios.empty()) {
        return 1;
    }
    const auto middle = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2);
    std::ranges::nth_element(ratios, middle);
    return *middle;
}

/// Sorts the most likely first; a mistake that leaves clearly more than the best is not a cause.
void rank(std::vector<Cause>& causes) {
    std::ranges::stable_sort(causes, {}, &Cause::scatter);
    if (causes.empty()) {
        return;
    }
    const double best = causes.front().scatter;
    std::erase_if(
        causes, [best](const Cause& cause) { return cause.scatter > as_little * best + roundoff; });
    for (std::size_t i = 0; i < causes.size(); ++i) { // variants of one mistake
        const auto rest = causes.begin() + static_cast<std::ptrdiff_t>(i) + 1;
        causes.erase(std::remove_if(rest, causes.end(),
                                    [&one = causes[i]](const Cause& other) {
                                        return other.name == one.name && other.what == one.what;
                                    }),
                     causes.end());
    }
    for (Cause& cause : causes) {
        for (const Cause& other : causes) {
            const bool new_name =
                other.name != cause.name &&
                std::ranges::find(cause.equally_likely, other.name) == cause.equally_likely.end();
            if (new_name) {
                cause.equally_likely.push_back(other.name);
            }
        }
    }
}

bool explains(const Fit& fit, double allowance, double unexplained,
              double standard_errors = usual_errors) {
    return fit.is_scatter(allowance, standard_errors) && fit.left < share_left * unexplained;
}

/// Every second node, from the first or the second one.
std::pair<Observed, Suspect> every_second(const Observed& data, const Suspect& right,
                                          std::size_t first) {
    Observed part{{data.nodes.data, {}}, {}, data.element, data.corners};
    Suspect values{right.name, right.what, right.a, right.b, {}};
    for (std::size_t i = first; i < data.nodes.size(); i += 2) {
        part.nodes.nodes.push_back(data.nodes.nodes[i]);
        part.values.push_back(data.values[i]);
        values.values.push_back(right.values[i]);
    }
    return {std::move(part), std::move(values)};
}

/// Means over three neighbours, with weights 1/4, 1/2 and 1/4.
std::pair<Observed, Suspect> means_of_three(const Observed& data, const Suspect& right) {
    Observed part{{data.nodes.data, {}}, {}, 2 * data.element, data.corners};
    Suspect values{right.name, right.what, right.a, right.b, {}};
    const auto mean = [](const std::vector<double>& v, std::size_t i) {
        return (v[i - 1] + 2 * v[i] + v[i + 1]) / 4;
    };
    for (std::size_t i = 1; i + 1 < data.nodes.size(); ++i) {
        part.nodes.nodes.push_back(data.nodes.nodes[i]);
        part.values.push_back(mean(data.values, i));
        values.values.push_back(mean(right.values, i));
    }
    return {std::move(part), std::move(values)};
}

/// Recognises data that alternate from node to node, as those at the corners and in the middles of
/// the sides of quadratic elements do: every second node is right, or the means over neighbours
/// are. Noise does not become three times smaller by either.
std::optional<Cause> alternation(const Observed& data, const Suspect& right, double allowance,
                                 double unexplained) {
    if (data.nodes.size() != data.nodes.data.nodes.size()) {
        return {}; // only some nodes are used
    }
    for (const std::size_t first : {0U, 1U}) {
        const auto [part, values] = every_second(data, right, first);
        const auto fit = fit_of(part, values);
        if (fit && explains(*fit, allowance, unexplained)) {
            const auto [others, other_values] = every_second(data, right, 1 - first);
            return Cause{
                "mid-side-nodes",
                fmt::format("every second node is right, and the others are {:.3g} times that: "
                            "corners and middles of the sides of quadratic elements",
                            median_ratio(others, other_values.values)),
                1,
                fit->left,
                {}};
        }
    }
    const auto [part, values] = means_of_three(data, right);
    const auto fit = fit_of(part, values);
    if (fit && explains(*fit, allowance, unexplained)) {
        return Cause{"mid-side-nodes",
                     "p alternates about the right one from node to node: corners and middles of "
                     "the sides of quadratic elements; give means over neighbours",
                     1,
                     fit->left,
                     {}};
    }
    return {};
}

Diagnosis diagnose_observed(const Observed& data, const Suspect& right,
                            const std::vector<Suspect>& suspects, double mesh_error) {
    Diagnosis diagnosis;
    const auto as_it_is = fit_of(data, right); // empty if hardly any node lies in the exact contact
    diagnosis.unexplained = as_it_is ? as_it_is->left : 1;
    if (as_it_is) {
        diagnosis.noise = as_it_is->noise;
        diagnosis.largest_inside = as_it_is->largest_counted;
        diagnosis.at_edges_only =
            as_it_is->is_scatter(std::max(right_as_a_mesh, std::min(mesh_error, most_of_a_mesh)));
    }
    // Noise of some percent needs the floor: the scatter of a few hundred nodes is not known
    // better.
    const double allowance =
        std::max(std::min(mesh_error, most_of_a_mesh),
                 std::min(right_as_a_mesh, share_of_error * diagnosis.unexplained));
    const double factor = median_ratio(data, right.values);
    // One mistake within three standard errors is named together with those within five: of some
    // hundred sets of data, the scale of the right one is off by more than three in some.
    bool explained = false;
    for (const Suspect& suspect : suspects) {
        const auto fit = fit_of(data, suspect);
        if (fit && explains(*fit, allowance, diagnosis.unexplained, most_errors)) {
            diagnosis.causes.push_back({suspect.name, suspect.what, factor, fit->left, {}});
            explained = explained || explains(*fit, allowance, diagnosis.unexplained);
        }
    }
    if (!explained) {
        diagnosis.causes.clear();
    }
    rank(diagnosis.causes);
    if (diagnosis.causes.empty() && as_it_is) {
        if (auto cause = alternation(data, right, allowance, diagnosis.unexplained)) {
            diagnosis.causes.push_back(std::move(*cause));
        }
    }
    if (!diagnosis.causes.empty()) {
        diagnosis.noise = diagnosis.causes.front().scatter;
    } else if (as_it_is && !diagnosis.at_edges_only) {
        Suspect scaled = right;
        for (double& value : scaled.values) {
            value *= as_it_is->scale;
        }
        const auto fit = fit_of(data, scaled);
        if (fit && explains(*fit, allowance, diagnosis.unexplained)) {
            diagnosis.factor = {as_it_is->scale, fit->scale_error * std::abs(as_it_is->scale)};
            diagnosis.noise = fit->noise;
        }
    }
    return diagnosis;
}

} // namespace

Diagnosis diagnose(const ResultTable& table, const AlignedResult& data, const DataContact& contact,
                   SuspectContacts& suspects, const ExactContact& exact, double mesh_error) {
    Observed observed = observed_in(data, contact, exact);
    Suspect right{"", "", exact.a().value, exact.b().value, {}};
    for (std::size_t i = 0; i < observed.nodes.size(); ++i) {
        const Node& node = observed.nodes[i];
        observed.values.push_back(node.p);
        right.values.push_back(node.exact.p.value_or(std::nan("")));
    }
    Diagnosis diagnosis = diagnose_observed(
        observed, right, pressure_suspects(observed.nodes, suspects, exact), mesh_error);
    if (diagnosis.at_edges_only && diagnosis.causes.empty()) {
        if (const auto cause = cause_in_digits(table, data, exact)) {
            diagnosis.causes.push_back(*cause);
        }
    }
    return diagnosis;
}

Diagnosis diagnose_shear(const AlignedResult& data, const DataContact& contact,
                         SuspectContacts& suspects, const ExactContact& exact, double mesh_error) {
    Observed observed = observed_in(data, contact, exact);
    Suspect right{"", "", exact.a().value, exact.b().value, {}};
    for (std::size_t i = 0; i < observed.nodes.size(); ++i) {
        const auto& shear = observed.nodes[i].shear;
        observed.values.push_back(shear ? shear->q : 0);
        right.values.push_back(shear ? shear->exact.value_or(std::nan("")) : std::nan(""));
    }
    return diagnose_observed(observed, right, shear_suspects(observed.nodes, suspects, exact),
                             mesh_error);
}

namespace {

constexpr int most_rounded_digits = 9;
constexpr double half_unit = 0.51; ///< of the last digit, with a little for binary64
constexpr double near_edge_share = 0.02;
constexpr double units_of_binary32 = 16;
/// Rounding errors are uniformly distributed, with an rms of 1/sqrt(3) of the largest; the data's
/// own noise, which is smaller, adds to them.
constexpr double rms_with_noise = 0.65;
constexpr double largest_with_noise = 2;

/// True if rounding by `allowed` at each node explains all errors that count.
template <class Allowed>
bool explains(const AlignedResult& data, const ExactContact& exact, const Allowed& allowed) {
    double largest = 0;
    double squares = 0;
    std::size_t n = 0;
    for (const Node& node : data.nodes) {
        if (node.exact.p && node.exact.u() > near_edge_share * exact.length()) {
            const double part = std::abs(node.error) / std::max(allowed(node), node.rounding);
            largest = std::max(largest, part);
            squares += part * part;
            ++n;
        }
    }
    return largest <= 1 || (largest <= largest_with_noise &&
                            squares <= rms_with_noise * rms_with_noise * static_cast<double>(n));
}

} // namespace

std::optional<Cause> cause_in_digits(const ResultTable& table, const AlignedResult& data,
                                     const ExactContact& exact) {
    const CarriedDigits& digits = table.p_digits;
    const double factor = table.p_factor;
    const auto significant_unit = [&](const Node& node) {
        const double p = std::abs(node.p / factor);
        const double leading = p > 0 ? std::floor(std::log10(p * (1 + 1e-15))) : -300;
        return half_unit * factor * std::pow(10.0, leading - digits.significant + 1);
    };
    const auto decimal_unit = [&](const Node&) {
        return half_unit * factor * std::pow(10.0, -digits.decimals);
    };
    const auto cause = [](const std::string& name, const std::string& what) {
        return Cause{name, what, 1, 0, {}};
    };
    const bool few = digits.significant <= most_rounded_digits;
    if (few && explains(data, exact, significant_unit)) {
        return cause(fmt::format("rounded-to-{}", digits.significant),
                     fmt::format("p is rounded to {} digits", digits.significant));
    }
    if (few && !digits.exponents && explains(data, exact, decimal_unit)) {
        return cause(fmt::format("rounded-to-{}-decimals", digits.decimals),
                     fmt::format("p is rounded to {} decimals", digits.decimals));
    }
    const double single = units_of_binary32 * std::ldexp(exact.scale().value, -24);
    if (digits.binary32 && explains(data, exact, [single](const Node&) { return single; })) {
        return cause("binary32", "p consists of binary32 numbers, about 7 digits");
    }
    return {};
}

} // namespace edgeproof::comparison
