// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/comparison/measures/data_edges.hpp"

#include <string>
#include <vector>

namespace edgeproof::comparison {

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
