// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>

namespace edgeproof::contact {

/// An edge of the contact -b < x < a. Distances u run inwards from it: u = a - x or u = b + x.
enum class Edge { right, left };

[[nodiscard]] constexpr Edge opposite(Edge edge) {
    return edge == Edge::right ? Edge::left : Edge::right;
}
/// The index of an edge in arrays that hold one entry for each edge.
[[nodiscard]] constexpr std::size_t index_of(Edge edge) { return edge == Edge::right ? 0 : 1; }

} // namespace edgeproof::contact
