// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/comparison/measures/measures.hpp"

#include "edgeproof/conformance/answers/number_text.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/roots/power_law_fit.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

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
        errors.inside += node.exact.inside() ? 1 : 0;
        const bool has_size = node.exact.inside() && *value.exact != 0;
        const double size = has_size ? std::abs(*value.exact) : scale;
        if (error / size > errors.local || !errors.worst_local) {
            errors.local = error / size;
            errors.worst_local = i;
        }
        if (has_size) {
            local.push_back(error / size);
            errors.as_written = std::max(errors.as_written, std::abs(value.error) / size);
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
    const double width = zone.length.value_or(zone.elements * contact.mean_element);
    const auto counts = [&, ends = exact.shear()->stick_edges()](const Node& node) {
        return is_counted(node, zone, contact) &&
               std::ranges::none_of(ends, [&](double x) { return std::abs(node.x - x) < width; });
    };
    return errors_of(data, exact.shear()->scale(), counts, held_traction, false);
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

namespace {

constexpr double least_order = 0.1;
constexpr double greatest_order = 8;

/// The slope of log |error| over log h. An error of 0 has no logarithm and is left out.
std::optional<double> slope_of(const std::vector<MeshValue>& errors) {
    std::vector<std::pair<double, double>> points;
    for (const MeshValue& e : errors) {
        points.emplace_back(e.h, std::abs(e.value));
    }
    const auto fit = roots::power_law_fit(points);
    return fit ? std::optional(fit->exponent) : std::nullopt;
}

/// Solves (v1 - v2)/(v2 - v3) = (h1^p - h2^p)/(h2^p - h3^p) for p; the right side grows with p.
std::optional<double> order_of_triple(const MeshValue& v1, const MeshValue& v2,
                                      const MeshValue& v3) {
    const double ratio = (v1.value - v2.value) / (v2.value - v3.value);
    const auto excess = [&](double p) {
        const double r1 = std::pow(v1.h / v3.h, p);
        const double r2 = std::pow(v2.h / v3.h, p);
        return (r1 - r2) / (r2 - 1) - ratio;
    };
    if (!(ratio > 0) || !std::isfinite(ratio) || excess(least_order) > 0 ||
        excess(greatest_order) < 0) {
        return {};
    }
    double lower = least_order;
    double upper = greatest_order;
    for (int i = 0; i < 80; ++i) {
        const double middle = 0.5 * (lower + upper);
        (excess(middle) < 0 ? lower : upper) = middle;
    }
    return 0.5 * (lower + upper);
}

/// Sorts the finest mesh last; of meshes with the same width keeps the last.
std::vector<MeshValue> by_width(std::vector<MeshValue> values) {
    std::ranges::stable_sort(values,
                             [](const MeshValue& s, const MeshValue& t) { return s.h > t.h; });
    std::vector<MeshValue> out;
    for (const MeshValue& v : values) {
        constexpr double same = 0.99;
        if (!out.empty() && v.h > same * out.back().h) {
            out.back() = v;
        } else {
            out.push_back(v);
        }
    }
    return out;
}

} // namespace

Convergence converge(std::string quantity, std::vector<MeshValue> values, double exact) {
    values = by_width(std::move(values));
    Convergence c;
    c.quantity = std::move(quantity);
    c.exact = exact;
    std::vector<MeshValue> errors = values;
    for (MeshValue& e : errors) {
        constexpr double roundoff = 1e-8; // of printed digits: an error of that size has no order
        e.value = std::abs(e.value - exact) < roundoff * std::abs(exact) ? 0 : e.value - exact;
    }
    c.order = slope_of(errors);
    const std::size_t n = values.size();
    if (n < 3) {
        c.why_not = "three meshes of different widths are needed";
        return c;
    }
    c.own_order = order_of_triple(values[n - 3], values[n - 2], values[n - 1]);
    if (!c.own_order) {
        c.why_not = "the last three values do not converge as a power of the width";
        return c;
    }
    const double rest = (values[n - 1].value - values[n - 2].value) /
                        (std::pow(values[n - 2].h / values[n - 1].h, *c.own_order) - 1);
    c.extrapolated = values[n - 1].value + rest;
    if (n >= 4) {
        const auto before = order_of_triple(values[n - 4], values[n - 3], values[n - 2]);
        c.trusted = before && std::abs(*before / *c.own_order - 1) < 0.2;
        c.why_not = c.trusted ? "" : "the orders of the last two triples of meshes differ";
    } else {
        c.why_not = "a fourth mesh is needed to see whether the order holds";
    }
    constexpr double where_orders_agree = 1.25;
    constexpr double elsewhere = 3;
    c.extrapolation_error = (c.trusted ? where_orders_agree : elsewhere) * std::abs(rest);
    c.agrees = std::abs(*c.extrapolated - exact) <= c.extrapolation_error;
    return c;
}

Convergence converge_error(std::string quantity, std::vector<MeshValue> errors) {
    Convergence c;
    c.quantity = std::move(quantity);
    c.order = slope_of(by_width(std::move(errors)));
    c.why_not = "it is an error, whose limit is 0";
    return c;
}

} // namespace edgeproof::comparison
