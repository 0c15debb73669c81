// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/comparison/causes/fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace edgeproof::comparison {
namespace {

constexpr double share_of_one_sign = 0.9;

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

/// True if the part of the error that changes its sign from node to node has one sign at nearly all
/// nodes of the contact, if every second sign is reversed.
bool has_one_sign(const Observed& data, const Suspect& right) {
    const auto inside = [&](std::size_t i) {
        return data.counts(right, i) && data.nodes[i].x < right.a && data.nodes[i].x > -right.b;
    };
    const auto error = [&](std::size_t i) { return data.values[i] - right.values[i]; };
    std::size_t all = 0;
    std::size_t positive = 0;
    for (std::size_t i = 1; i + 1 < data.nodes.size(); ++i) {
        if (inside(i - 1) && inside(i) && inside(i + 1)) {
            const double part = 2 * error(i) - error(i - 1) - error(i + 1);
            positive += (part > 0) == (i % 2 == 0) ? 1 : 0;
            ++all;
        }
    }
    return static_cast<double>(std::max(positive, all - positive)) >=
           share_of_one_sign * static_cast<double>(all);
}

} // namespace

std::optional<Cause> alternation(const Observed& data, const Suspect& right, double allowance,
                                 double unexplained) {
    if (data.nodes.size() != data.nodes.data.nodes.size() || !has_one_sign(data, right)) {
        return {}; // if only some nodes are used, they are not neighbours
    }
    for (const std::size_t first : {0U, 1U}) {
        const auto [part, values] = every_second(data, right, first);
        const auto fit = fit_of(part, values);
        if (fit && explains(*fit, allowance, unexplained)) {
            const auto [others, other_values] = every_second(data, right, 1 - first);
            const double off = median_ratio(others, other_values.values) - 1;
            return Cause{"mid-side-nodes",
                         fmt::format("every second node is right, and the others are {:.3g} % too "
                                     "{} in the median: corners and middles of the sides of "
                                     "quadratic elements",
                                     100 * std::abs(off), off < 0 ? "small" : "large"),
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

} // namespace edgeproof::comparison
