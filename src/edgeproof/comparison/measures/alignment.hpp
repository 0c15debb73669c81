// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/comparison/input/result_table.hpp"
#include "edgeproof/comparison/measures/exact_contact.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace edgeproof::comparison {

/// The pressure, or the shear traction, at a node.
struct Traction {
    double data = 0;             ///< in the scene's direction; p is positive in compression
    std::optional<double> exact; ///< empty if it is infinite
    double error = 0;            ///< of the data, unrounded; 0 if the exact one is infinite
    double rounding = 0; ///< the change of `error` by the rounding of the written value and x

    /// The error that the rounding does not explain; infinite if the value is not finite.
    [[nodiscard]] double counted() const {
        const double left = std::abs(error) - rounding;
        return std::isfinite(left) ? std::max(0.0, left) : std::numeric_limits<double>::infinity();
    }
};

/// A node of a result with the exact tractions.
struct Node {
    std::size_t line = 0;
    double x = 0; ///< from the scene's origin
    ExactContact::Place place;
    Traction p;
    std::optional<Traction> q; ///< if data and scene have one
};
/// The pressure of a node, or its shear traction; null if there is none.
using TractionOf = const Traction* (*)(const Node&);
[[nodiscard]] inline const Traction* p_of(const Node& node) { return &node.p; }
[[nodiscard]] inline const Traction* q_of(const Node& node) { return node.q ? &*node.q : nullptr; }

/// Data in the coordinates of the exact solution.
struct AlignedResult {
    std::vector<Node> nodes; ///< by x
    double sign = 1;         ///< of compression in the data
    double shear_sign = 1;   ///< of the scene's direction of q in the data
    double origin = 0;       ///< the x of the data at the scene's origin
    bool origin_found = false;
    /// Set if the data begin (or end) in the middle of a symmetric contact.
    std::optional<contact::Edge> half;
    std::vector<std::string> findings;

    /// False for the edge of the missing half.
    [[nodiscard]] bool has(contact::Edge edge) const { return !half || *half == edge; }
};

/// `origin`: the x of the data at the scene's origin; if empty, that of found_shift(), or 0 if it
/// is less than a fiftieth of a + b. Leave it empty only if the user requests a fitted origin: a
/// shift is an error of the data.
[[nodiscard]] AlignedResult align(const ResultTable& table, const ExactContact& exact,
                                  const std::optional<Rational>& origin);

/// The integral over x by trapezoids, over the nodes for which value(node) is not empty.
template <class Nodes, class Value>
[[nodiscard]] double trapezoids(const Nodes& nodes, const Value& value) {
    double sum = 0;
    double last_x = 0;
    std::optional<double> last;
    for (const auto& node : nodes) {
        if (const std::optional<double> y = value(node)) {
            sum += last ? 0.5 * (node.x - last_x) * (*last + *y) : 0;
            last_x = node.x;
            last = y;
        }
    }
    return sum;
}

/// The force of the tractions value(node), by trapezoids; for half a contact, that of both halves.
template <class Value>
[[nodiscard]] double force_of(const AlignedResult& data, const ExactContact& exact,
                              const Value& value) {
    return (data.half ? 2 : 1) * trapezoids(data.nodes, [&](const Node& node) {
               std::optional<double> traction = value(node);
               return traction ? std::optional(*traction * exact.force_width(node.x)) : traction;
           });
}

/// Half the distance between the neighbouring places of node i, divided among the nodes at its
/// place. `nodes`: by x.
template <class Nodes> [[nodiscard]] double width_of_node(const Nodes& nodes, std::size_t i) {
    const double x = nodes[i].x;
    const auto of_x = [](const auto& node) { return node.x; };
    const auto begin = std::ranges::lower_bound(nodes, x, {}, of_x);
    const auto end = std::ranges::upper_bound(nodes, x, {}, of_x);
    const double before = begin != nodes.begin() ? std::prev(begin)->x : x;
    const double after = end != nodes.end() ? end->x : x;
    return 0.5 * (after - before) / static_cast<double>(end - begin);
}

/// A node of the data in double precision, for the search of a shift.
struct RoughPoint {
    double x;
    double p;
};

/// A shift of x: the scene's origin in the x of the data.
struct FoundShift {
    Real exact;             ///< a round number or a usual place, if the fit agrees with it
    double uncertainty = 0; ///< of x, otherwise
    std::string_view what; ///< the usual place: ": x is measured from the left edge of the contact"
    bool clear = false;    ///< it halves the squares of the errors
};
/// Finds the shift with the least squares of p less the exact pressure, at nodes away from edges
/// and corners: within a tenth of a + b of that of the loaded interval (with any factor of p), or
/// of 0 if the former is not clear. Returns nothing if no node is loaded. `points`: by x. `half`:
/// the half of a symmetric contact that the data contain.
[[nodiscard]] std::optional<FoundShift> found_shift(const std::vector<RoughPoint>& points,
                                                    const std::optional<contact::Edge>& half,
                                                    const ExactContact& exact);

} // namespace edgeproof::comparison
