// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/comparison/causes/observed.hpp"
#include "edgeproof/comparison/causes/soft_contact.hpp"

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

    /// The scene's contact with springs.
    [[nodiscard]] const SoftContact& soft(const ExactContact& exact);

private:
    scene::Scene scene_;
    std::map<std::string, std::optional<ExactContact>> solved_;
    std::optional<SoftContact> soft_;
};

/// Returns every mistake in the pressure that is possible for a scene: p or x times a number, other
/// materials, sizes, angles and loads, other places, means over elements, and terms of an expansion
/// instead of p. Mistakes whose contact cannot be solved are left out. Throws Interrupted.
[[nodiscard]] std::vector<Suspect>
pressure_suspects(const Observed& data, SuspectContacts& contacts, const ExactContact& exact);
/// Returns the mistakes in the shear traction, if the pressure is right.
[[nodiscard]] std::vector<Suspect> shear_suspects(const Observed& data, SuspectContacts& contacts,
                                                  const ExactContact& exact);

} // namespace edgeproof::comparison
