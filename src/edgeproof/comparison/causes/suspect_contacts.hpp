// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/comparison/measures/exact_contact.hpp"

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>

namespace edgeproof::comparison {

/// The contacts that programs with a known mistake would have solved in place of a scene's. Each is
/// solved once, when it is first asked for, for all data that are held against the scene: solving
/// them is nearly all the work of a diagnosis. One object belongs to one thread.
class SuspectContacts {
public:
    explicit SuspectContacts(scene::Scene scene) : scene_(std::move(scene)) {}

    [[nodiscard]] const scene::Scene& scene() const { return scene_; }

    /// The contact of the scene with a change, which `mistake` tells from all others; null where no
    /// contact carries the changed scene's load, so that no program could have computed it.
    [[nodiscard]] const ExactContact* with(const std::string& mistake,
                                           const std::function<void(scene::Scene&)>& change);

private:
    scene::Scene scene_;
    std::map<std::string, std::unique_ptr<ExactContact>> solved_;
};

} // namespace edgeproof::comparison
