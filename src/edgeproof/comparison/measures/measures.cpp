// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/comparison/measures/measures.hpp"

#include "edgeproof/conformance/answers/number_text.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace edgeproof::comparison {
namespace {

constexpr double most_digits = 16;

/// The value of a node that is compared: its pressure, or its traction.
struct HeldValue {
    std::optional<double> exact;
    double error = 0;
    double rounding = 0;

    /// Infinite if the value is not finite: such an error is never small.
    [[nodiscard]] double counted() const {
        const double left = std::abs(error) - rounding;
        return std::isfinite(left) ? std::max(0.0, left) : std::numeric_limits<double>::infinity();
    }
};

HeldValue held_pressure(const Node& node) { return {node.exact.p, node.error, node.rounding}; }
HeldValue held_traction(const Node& node) {
    return node.shear ? HeldValue{node.shear->exact, node.shear->error, node.shear->rounding}
                      : HeldValue{};
}

/// `whole`: the norm of the exact value includes all nodes, not only those counted.
Errors errors_of(const AlignedResult& data, double scale,
                 const std::function<bool(const Node&)>& counts,
                 HeldValue (*held)(const Node&) = held_pressure, bool whole = true) {
    Errors errors;
    std::vector<double> local;
    double square = 0;
    double exact_square = 0;
    for (std::size_t i = 0; i < data.nodes.size(); ++i) {
        const Node& node = data.nodes[i];
        const HeldValue value = held(node);
        if (!value.exact) {
            continue;
        }
        const double width = width_of_node(data.nodes, i);
        const bool counted = counts(node);
        exact_square += whole || counted ? width * *value.exact * *value.exact : 0;
        if (!counted) {
            continue;
        }
        ++errors.nodes;
        const double error = value.counted();
        square += width * error * error;
        if (error / scale > errors.peak || !errors.worst) {
            errors.peak = error / scale;
            errors.worst = i;
        }
        if (node.exact.inside() && *value.exact != 0) {
            const double size = std::abs(*value.exact);
            local.push_back(error / size);
            errors.as_written = std::max(errors.as_written, std::abs(value.error) / size);
            if (local.back() > errors.local || !errors.worst_local) {
                errors.local = local.back();
                errors.worst_local = i;
            }
        }
    }
    errors.l2 = exact_square > 0 ? std::sqrt(square / exact_square) : 0;
    if (!local.empty()) {
        const auto middle = local.begin() + static_cast<std::ptrdiff_t>(local.size() / 2);
        std::ranges::nth_element(local, middle);
        errors.median_local = *middle;
    }
    return errors;
}

} // namespace

double digits_of(double relative_error) {
    return relative_error > 0 ? std::min(most_digits, std::max(0.0, -std::log10(relative_error)))
                              : most_digits;
}

double Errors::digits() const { return digits_of(as_written); }

EdgeZone parse_edge_zone(std::string_view text) {
    const bool elements = text.ends_with('e') || text.ends_with('E');
    const auto number =
        conformance::written_number(elements ? text.substr(0, text.size() - 1) : text);
    if (number.kind != conformance::WrittenNumber::Kind::number || number.value < 0) {
        throw InputError("--edge-zone " + std::string(text) + " is no width",
                         "write 2e for two elements, or a length such as 0.01");
    }
    const double value = number.value.convert_to<double>();
    return elements || value == 0 ? EdgeZone{value, {}} : EdgeZone{0, value};
}

bool is_counted(const Node& node, const EdgeZone& zone, const DataContact& contact) {
    // A node on the boundary of the zone is counted in spite of rounding.
    constexpr double almost = 1 - 1e-9;
    const double right = zone.at(contact::Edge::right, contact) * almost;
    const double left = zone.at(contact::Edge::left, contact) * almost;
    return node.exact.p && std::abs(node.exact.from_right) >= right &&
           std::abs(node.exact.from_left) >= left;
}

Errors measure(const AlignedResult& data, const ExactContact& exact, const DataContact& contact,
               const EdgeZone& zone) {
    return errors_of(data, exact.scale().value,
                     [&](const Node& node) { return is_counted(node, zone, contact); });
}

std::optional<Errors> measure_shear(const AlignedResult& data, const ExactContact& exact,
                                    const DataContact& contact, const EdgeZone& zone) {
    if (data.nodes.empty() || !data.nodes.front().shear) {
        return {};
    }
    return errors_of(
        data, exact.shear()->scale(),
        [&](const Node& node) { return is_counted(node, zone, contact); }, held_traction, false);
}

std::vector<DistanceErrors> by_distance(const AlignedResult& data, const ExactContact& exact) {
    std::vector<DistanceErrors> list;
    constexpr int decades = 12;
    for (const contact::Edge edge : {contact::Edge::right, contact::Edge::left}) {
        for (int k = 0; k < decades; ++k) {
            const double to = k == 0 ? 0.5 : std::pow(10.0, -k);
            const double from = k + 1 == decades ? 0 : std::pow(10.0, -k - 1);
            const Errors errors = errors_of(data, exact.scale().value, [&](const Node& node) {
                const double part = node.exact.u() / exact.length();
                return node.exact.inside() && node.exact.nearer() == edge && part > from &&
                       part <= (k == 0 ? 1 : to);
            });
            if (errors.nodes > 0) {
                list.push_back({edge, from, to, errors});
            }
        }
    }
    return list;
}

std::vector<KnotErrors> errors_near_knots(const AlignedResult& data, const ExactContact& exact,
                                          const DataContact& contact) {
    std::vector<KnotErrors> list;
    const double near = std::max(0.01 * exact.length(), 2 * contact.mean_element);
    for (const ContactKnot& knot : exact.knots()) {
        const Errors errors = errors_of(data, exact.scale().value, [&](const Node& node) {
            return node.exact.inside() && std::abs(node.x - knot.x) <= near;
        });
        if (errors.nodes > 0) {
            list.push_back({knot, errors});
        }
    }
    return list;
}

} // namespace edgeproof::comparison
