// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/comparison/measures/alignment.hpp"
#include "edgeproof/comparison/measures/exact_contact.hpp"

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace edgeproof::comparison {

/// The contacts that programs with a known mistake would have solved instead of the scene's. Each
/// is solved once, on first use, for all data compared with the scene: solving them is nearly all
/// the work of a diagnosis. One object belongs to one thread.
class SuspectContacts {
public:
    explicit SuspectContacts(scene::Scene scene) : scene_(std::move(scene)) {}

    [[nodiscard]] const scene::Scene& scene() const { return scene_; }

    /// The contact of the changed scene; `mistake` is a unique name of the change. Null if no
    /// contact carries the load of the changed scene, so that no program could have computed it.
    [[nodiscard]] const ExactContact* with(const std::string& mistake,
                                           const std::function<void(scene::Scene&)>& change);

private:
    scene::Scene scene_;
    std::map<std::string, std::optional<ExactContact>> solved_;
};

/// The values that a program with one mistake would write at the nodes used.
struct Suspect {
    std::string name;
    std::string what;
    double a = 0; ///< its contact is -b < x < a
    double b = 0;
    std::vector<double> values; ///< at each of those nodes; NaN where there is no value
};

/// The nodes of data that are used: if there are many, only some of them at equal steps.
struct UsedNodes {
    const AlignedResult& data;
    std::vector<std::size_t> nodes; ///< indices, in their order

    [[nodiscard]] std::size_t size() const { return nodes.size(); }
    [[nodiscard]] const Node& operator[](std::size_t i) const { return data.nodes[nodes[i]]; }
};

/// Returns every mistake in the pressure that is possible for a scene: p or x times a number, other
/// materials, sizes, angles and loads, other places, means over elements, and terms of an expansion
/// instead of p. Mistakes whose contact cannot be solved are left out. Throws Interrupted.
[[nodiscard]] std::vector<Suspect>
pressure_suspects(const UsedNodes& nodes, SuspectContacts& contacts, const ExactContact& exact);
/// Returns the mistakes in the shear traction, if the pressure is right.
[[nodiscard]] std::vector<Suspect> shear_suspects(const UsedNodes& nodes, SuspectContacts& contacts,
                                                  const ExactContact& exact);

} // namespace edgeproof::comparison
