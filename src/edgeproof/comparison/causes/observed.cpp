// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/comparison/causes/causes.hpp"
#include "edgeproof/precision/interruption.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace edgeproof::comparison {
namespace {

constexpr std::size_t most_nodes = 1000;
constexpr std::size_t fewest_nodes_counted = 8;
constexpr double edge_share = 0.02; ///< relative to the suspect's contact
constexpr double least_unit = 0.1;  ///< relative to the largest value

double root_mean(double squares, std::size_t n) {
    return n > 0 ? std::sqrt(squares / static_cast<double>(n)) : 0;
}

/// The standard deviation of errors that scatter from node to node, by their second differences.
double scatter_of(const std::vector<double>& errors) {
    double squares = 0;
    std::size_t n = 0;
    for (std::size_t i = 2; i < errors.size(); ++i) {
        const double second = errors[i - 2] - 2 * errors[i - 1] + errors[i];
        if (std::isfinite(second)) {
            squares += second * second / 6;
            ++n;
        }
    }
    return root_mean(squares, n);
}

} // namespace

bool Observed::counts(const Suspect& suspect, std::size_t i) const {
    const double zone = std::max(2 * element, edge_share * (suspect.a + suspect.b));
    const double x = (*this)[i].x;
    return std::isfinite(suspect.values[i]) && std::isfinite(right.values[i]) &&
           std::min(std::abs(x - suspect.a), std::abs(x + suspect.b)) >= zone &&
           std::ranges::none_of(corners, [=](double at) { return std::abs(x - at) < zone; });
}

bool Observed::inside(const Suspect& suspect, std::size_t i) const {
    return counts(suspect, i) && (*this)[i].x < suspect.a && (*this)[i].x > -suspect.b;
}

std::vector<double> Observed::ratios(const Suspect& to) const {
    std::vector<double> list;
    for (std::size_t i = 0; i < size(); ++i) {
        if (std::isfinite(to.values[i]) && to.values[i] != 0) {
            list.push_back(values[i] / to.values[i]);
        }
    }
    return list;
}

Observed Observed::part(std::optional<std::size_t> parity) const {
    Observed part{data, {}, {}, right, element * (parity ? 1 : 2), corners};
    part.right.values.clear();
    const std::size_t end = size() - (parity ? 0 : 1);
    for (std::size_t i = parity.value_or(1); i < end; i += 2) {
        const auto at = [&](const std::vector<double>& v) {
            return parity ? v[i] : (v[i - 1] + 2 * v[i] + v[i + 1]) / 4;
        };
        part.nodes.push_back(nodes[i]);
        part.values.push_back(at(values));
        part.right.values.push_back(at(right.values));
    }
    return part;
}

Suspect Observed::suspect(std::string_view name, std::string what, double a, double b,
                          const std::function<double(std::size_t)>& value) const {
    Suspect s{std::string(name), std::move(what), a, b, {}};
    for (std::size_t i = 0; i < size(); ++i) {
        check_interruption();
        s.values.push_back(value(i));
    }
    return s;
}

std::optional<Left> Observed::left_by(const Suspect& suspect) const {
    double products = 0;
    double largest = 0;
    double largest_right = 0;
    for (std::size_t i = 0; i < size(); ++i) {
        if (counts(suspect, i)) {
            products += values[i] * suspect.values[i];
            largest = std::max(largest, std::abs(suspect.values[i]));
            largest_right = std::max(largest_right, std::abs(right.values[i]));
        }
    }
    const double sign = products < 0 ? -1 : 1; // a mistake may make the pressure mainly tensile
    Left left;
    double squares = 0;
    double squares_inside = 0;
    std::size_t all = 0;
    std::size_t within = 0;
    std::pair worst{0.0, Worst::near_edge};
    std::vector<double> errors(size(), std::nan("")); // of the nodes inside
    std::optional<std::size_t> neighbour;
    for (std::size_t i = 0; i < size(); ++i) {
        const double value = suspect.values[i];
        const double number = sign * values[i];
        const double off = (number - value) / largest;
        const bool counted = counts(suspect, i);
        const bool is_inside = inside(suspect, i);
        if (std::isfinite(value)) {
            worst = std::max(worst, {std::abs(number - value), is_inside ? Worst::inside
                                                               : counted ? Worst::outside
                                                                         : Worst::near_edge});
        }
        all += counted ? 1 : 0;
        squares += counted ? off * off : 0;
        if (is_inside) {
            ++within;
            squares_inside += off * off;
            errors[i] = off;
        }
        if (!counted || (value == 0 && number == 0)) {
            neighbour.reset();
            continue;
        }
        const double error = std::abs(values[i] - right.values[i]);
        const double unit = std::max(std::abs(value), least_unit * largest);
        const double unit_of_right =
            std::max(std::abs(right.values[i]), least_unit * largest_right);
        left.rows.off.push_back((number - value) / unit);
        left.rows.before.push_back(error / unit_of_right);
        left.rows.ratio.push_back(std::max(
            error / unit_of_right, error / std::max(std::abs(number), least_unit * largest)));
        left.rows.change.push_back(std::abs(sign * value - right.values[i]) / unit_of_right);
        const std::size_t here = left.rows.off.size() - 1;
        if (neighbour && is_inside) {
            left.rows.neighbours.emplace_back(*neighbour, here);
        }
        neighbour = is_inside ? std::optional(here) : std::nullopt;
    }
    if (!(largest > 0) || within < fewest_nodes_counted) {
        return {};
    }
    left.rms = root_mean(squares, all);
    left.inside = root_mean(squares_inside, within);
    left.noise = scatter_of(errors);
    left.worst = worst.second;
    return left;
}

Observed observed_in(const AlignedResult& data, const DataContact& contact,
                     const ExactContact& exact, TractionOf of) {
    Observed observed{data,
                      {},
                      {},
                      {"", "", exact.a().value, exact.b().value, {}},
                      std::max(contact.element[0], contact.element[1]),
                      {}};
    const std::size_t step = (data.nodes.size() + most_nodes - 1) / most_nodes;
    for (std::size_t i = 0; i < data.nodes.size(); i += std::max<std::size_t>(1, step)) {
        const Traction* const t = of(data.nodes[i]);
        observed.nodes.push_back(i);
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

} // namespace edgeproof::comparison
