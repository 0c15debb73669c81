// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/comparison/measures/alignment.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace edgeproof::comparison {

/// A node presses if |p| exceeds this share of the greatest pressure of the data.
inline constexpr double pressing_fraction = 0.002;

/// The contact according to the data. All values are estimates: a mesh determines an edge to one
/// element.
struct DataContact {
    std::optional<double> a; ///< empty if no node is loaded, or if the data end inside the contact
    std::optional<double> b;
    /// The width of the element that contains the exact edge, or of the nearest one if the data do
    /// not reach it; 0 if there is none. The index is index_of(edge).
    std::array<double, 2> element{};
    double mean_element = 0; ///< width divided by the number of nodes inside the exact contact
    std::array<bool, 2> reaches{}; ///< the data reach the exact edge, to one element
    std::optional<double> force;   ///< by trapezoids; doubled for half a contact
    double largest = 0;            ///< the largest pressure
    std::size_t gaps = 0;          ///< places inside where the pressure falls to zero

    /// a or b
    [[nodiscard]] const std::optional<double>& at(contact::Edge edge) const {
        return edge == contact::Edge::right ? a : b;
    }
};

/// Near an edge p^2 is smooth and nearly linear in the distance, so an edge of the data is the zero
/// of the parabola through the last three p^2, limited to the interval between the last loaded node
/// and the first unloaded one. A node is loaded if p is more than 1/500 of the largest, and more
/// than four times the scatter of the nodes outside (but at most 1/20 of the largest).
[[nodiscard]] DataContact contact_of(const AlignedResult& data, const ExactContact& exact);

enum class Determined { a, b, force, largest };

/// A quantity that the nodes do not determine, with the reason as a sentence.
struct Undetermined {
    Determined quantity;
    std::string why;
};

/// Returns the quantities that the nodes of the data do not determine, independent of the pressures
/// at them:
/// - an edge, if the nodes end more than one element inside it, or if the rule for edges, applied
///   to the exact pressure at these nodes, has an error of more than a tenth of a + b;
/// - P, if trapezoids of the exact pressure at these nodes have an error of more than a tenth of P,
///   if two neighbours inside the contact are more than a quarter of a + b apart, or if half a
///   contact does not begin in its middle, to one element;
/// - the largest p, if the exact pressure at these nodes is never more than nine tenths of it. A
///   profile with a corner has none.
/// For half a contact, only the edge of that half is checked. `of_exact`: contact_of() the exact
/// pressure at these nodes.
[[nodiscard]] std::vector<Undetermined>
undetermined(const AlignedResult& data, const DataContact& of_exact, const ExactContact& exact);

} // namespace edgeproof::comparison
