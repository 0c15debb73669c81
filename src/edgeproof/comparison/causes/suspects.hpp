// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/comparison/causes/suspect_contacts.hpp"
#include "edgeproof/comparison/measures/alignment.hpp"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace edgeproof::comparison {

/// The values that a program with one mistake would write at the nodes used.
struct Suspect {
    std::string name;
    std::string what;
    double a = 0; ///< its contact is -b < x < a
    double b = 0;
    std::vector<double> values; ///< at each of those nodes; NaN where there is no value
};
using TakeSuspect = std::function<void(const Suspect&)>;

/// The nodes of data that are used: if there are many, only some of them at equal steps.
struct NodesLookedAt {
    const AlignedResult& data;
    std::vector<std::size_t> nodes; ///< indices, in their order

    [[nodiscard]] std::size_t size() const { return nodes.size(); }
    [[nodiscard]] const Node& operator[](std::size_t i) const { return data.nodes[nodes[i]]; }
};

/// Calls `take` with every mistake in the pressure that is possible for a scene, one after another.
/// Mistakes whose contact cannot be solved are left out.
void for_each_suspect(const NodesLookedAt& nodes, SuspectContacts& contacts,
                      const ExactContact& exact, const TakeSuspect& take);
/// Calls `take` with the mistakes in the shear traction, if the pressure is right.
void for_each_shear_suspect(const NodesLookedAt& nodes, SuspectContacts& contacts,
                            const ExactContact& exact, const TakeSuspect& take);

} // namespace edgeproof::comparison
