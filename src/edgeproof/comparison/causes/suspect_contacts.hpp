// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/comparison/measures/exact_contact.hpp"

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>

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
    std::map<std::string, std::unique_ptr<ExactContact>> solved_;
};

} // namespace edgeproof::comparison
