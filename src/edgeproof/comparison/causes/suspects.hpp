// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/comparison/causes/suspect_contacts.hpp"
#include "edgeproof/comparison/measures/alignment.hpp"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace edgeproof::comparison {

/// The values that a program with one mistake would write at the nodes looked at.
struct Suspect {
    std::string name;
    std::string what;
    double a = 0; ///< its contact is -b < x < a
    double b = 0;
    std::vector<double> values; ///< at each of those nodes; NaN where it says nothing
};
using TakeSuspect = std::function<void(const Suspect&)>;

/// Some of the nodes of data: of many, every so manieth will do.
struct NodesLookedAt {
    const AlignedResult& data;
    std::vector<std::size_t> nodes; ///< indices, in their order

    [[nodiscard]] std::size_t size() const { return nodes.size(); }
    [[nodiscard]] const Node& operator[](std::size_t i) const { return data.nodes[nodes[i]]; }
};

/// Every mistake in the pressure that makes sense of a scene. Those whose contact cannot be solved
/// are left out. `take` is called with one after another.
void for_each_suspect(const NodesLookedAt& nodes, SuspectContacts& contacts,
                      const ExactContact& exact, const TakeSuspect& take);
/// The same of the shear traction, the pressure being right.
void for_each_shear_suspect(const NodesLookedAt& nodes, SuspectContacts& contacts,
                            const ExactContact& exact, const TakeSuspect& take);

} // namespace edgeproof::comparison
