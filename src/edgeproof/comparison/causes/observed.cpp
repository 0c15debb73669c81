// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/comparison/causes/causes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace edgeproof::comparison {
namespace {

constexpr std::size_t most_nodes = 1000;
constexpr std::size_t fewest_nodes_counted = 8;
constexpr double edge_share = 0.02; ///< relative to the suspect's contact
constexpr double least_unit = 0.1;  ///< relative to the largest value
constexpr double share_of_one_sign = 0.9;

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

} // namespace

bool Observed::counts(const Suspect& suspect, std::size_t i) const {
    const double zone = std::max(2 * element, edge_share * (suspect.a + suspect.b));
    const double x = nodes[i].x;
    return std::isfinite(suspect.values[i]) && std::isfinite(right.values[i]) &&
           std::min(std::abs(x - suspect.a), std::abs(x + suspect.b)) >= zone &&
           std::ranges::none_of(corners, [=](double at) { return std::abs(x - at) < zone; });
}

bool Observed::inside(const Suspect& suspect, std::size_t i) const {
    return counts(suspect, i) && nodes[i].x < suspect.a && nodes[i].x > -suspect.b;
}

std::vector<double> Observed::ratios() const {
    std::vector<double> list;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (std::isfinite(right.values[i]) && right.values[i] != 0) {
            list.push_back(values[i] / right.values[i]);
        }
    }
    return list;
}

Observed Observed::part(std::optional<std::size_t> parity) const {
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
    double second = 0;
    std::size_t all = 0;
    std::size_t inside = 0;
    std::size_t seconds = 0;
    std::array<double, 2> worst{};             // of nodes near an edge, and of those that count
    std::array<std::optional<double>, 3> last; // errors of three nodes in turn
    std::optional<std::size_t> neighbour;
    for (std::size_t i = 0; i < data.nodes.size(); ++i) {
        const double value = suspect.values[i];
        const double number = sign * data.values[i];
        const bool counts = data.counts(suspect, i);
        const bool within = data.inside(suspect, i);
        if (std::isfinite(value)) {
            worst[counts ? 1 : 0] = std::max(worst[counts ? 1 : 0], std::abs(number - value));
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
    left.noise = seconds > 0 ? std::sqrt(second / static_cast<double>(seconds)) : 0;
    left.largest_counted = worst[1] >= worst[0];
    return left;
}

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
        if (!parity) {
            return Cause{"mid-side-nodes",
                         "p alternates about the right one from node to node: corners and middles "
                         "of the sides of quadratic elements; give means over neighbours",
                         1,
                         left->rms,
                         {}};
        }
        const double off = diagnose::sorted_at(data.part(1 - *parity).ratios(), 0.5) - 1;
        return Cause{"mid-side-nodes",
                     fmt::format("every second node is right, and the others are {:.3g} % too {} "
                                 "in the median: corners and middles of the sides of quadratic "
                                 "elements",
                                 100 * std::abs(off), off < 0 ? "small" : "large"),
                     1,
                     left->rms,
                     {}};
    }
    return {};
}

} // namespace edgeproof::comparison
