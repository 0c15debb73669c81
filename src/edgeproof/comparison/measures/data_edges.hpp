// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/comparison/measures/alignment.hpp"

#include <array>
#include <optional>

namespace edgeproof::comparison {

/// The contact according to the data. All values are estimates: a mesh determines an edge to one
/// element.
struct DataContact {
    std::optional<double> a; ///< empty if no node is loaded, or if the data end inside the contact
    std::optional<double> b;
    /// By index_of(edge): the width of the element that contains the exact edge, or of the nearest
    /// one if the data do not reach it. 0 if there is none.
    std::array<double, 2> element{};
    double mean_element = 0; ///< width divided by the number of nodes inside the exact contact
    std::array<bool, 2> reaches{}; ///< the data reach the exact edge, to one element
    std::optional<double> force;   ///< by trapezoids; doubled for half a contact
    double largest = 0;            ///< the largest pressure
    std::size_t gaps = 0;          ///< places inside where the pressure falls to zero
};

/// Near an edge p^2 is smooth and nearly linear in the distance, so an edge of the data is the zero
/// of the parabola through the last three p^2, limited to the interval between the last loaded node
/// and the first unloaded one. A node is loaded if p is more than 1/500 of the largest, and more
/// than four times the scatter of the nodes outside (but at most 1/20 of the largest).
[[nodiscard]] DataContact contact_of(const AlignedResult& data, const ExactContact& exact);

} // namespace edgeproof::comparison
