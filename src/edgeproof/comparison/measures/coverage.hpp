// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/comparison/measures/data_edges.hpp"

#include <string>
#include <vector>

namespace edgeproof::comparison {

/// What the nodes of a result must determine.
enum class Determined { a, b, force, largest };

/// A quantity that the nodes do not determine, and why, as a sentence.
struct Undetermined {
    Determined quantity;
    std::string why;
};

/// The quantities that the nodes of the data do not determine, whatever the pressures at them:
/// - an edge, where the nodes end more than one element inside it, or where the rule for edges,
///   applied to the exact pressure at these nodes, is off by more than a tenth of a + b;
/// - P, where trapezoids of the exact pressure at these nodes are off by more than a tenth of P,
///   where two neighbours inside the contact are more than a quarter of a + b apart, or where half
///   a contact does not begin in its middle, to an element;
/// - the largest p, where the exact pressure at these nodes is nowhere more than nine tenths of it.
///   A profile with a corner has none.
/// Of half a contact, the other edge is that of the half. `of_exact`: contact_of() the exact
/// pressure at these nodes.
[[nodiscard]] std::vector<Undetermined>
undetermined(const AlignedResult& data, const DataContact& of_exact, const ExactContact& exact);

} // namespace edgeproof::comparison
