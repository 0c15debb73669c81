// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/comparison/measures/alignment.hpp"

#include <array>
#include <optional>

namespace edgeproof::comparison {

/// The contact as the data have it. Estimates: a mesh knows an edge to an element.
struct DataContact {
    std::optional<double> a; ///< nothing where the data press nowhere, or end inside the contact
    std::optional<double> b;
    /// By index_of(edge): the width of the element that the exact edge lies in; the nearest one's
    /// where the data do not reach it. 0 where there is none.
    std::array<double, 2> element{};
    double mean_element = 0;       ///< width over nodes inside the exact contact
    std::array<bool, 2> reaches{}; ///< the data reach the exact edge, to an element
    std::optional<double> force;   ///< by trapezoids; twice that of half a contact
    double largest = 0;            ///< pressure
    std::size_t gaps = 0;          ///< places inside where the pressure falls to nothing
};

/// Near an edge p^2 is linear in the distance and smooth, so an edge of the data is where the
/// parabola through the last three p^2 vanishes, kept between the last node that presses and the
/// first that does not. A node presses where p is more than 1/500 of the largest, and than four
/// times the scatter of the nodes outside (but no more than 1/20 of the largest).
[[nodiscard]] DataContact contact_of(const AlignedResult& data, const ExactContact& exact);

} // namespace edgeproof::comparison
