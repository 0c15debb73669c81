// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/scene/input/scene_file.hpp"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

/// The catalogue of the mistakes that programs make. `edgeproof compare` and `edgeproof check`
/// search for the same mistakes and give them the same names.
namespace edgeproof::diagnose {

/// A mistake in the data of a scene.
struct Mistake {
    std::string_view name;   ///< the name of the cause in the output; several mistakes may share it
    std::string what;        ///< in words, without a verb: "the diameter instead of the radius"
    std::string_view advice; ///< what is right
    std::function<void(scene::Scene&)> change; ///< makes the scene that such a program solves
};

/// The possible mistakes in the moduli, the profile and the load. The changed scene need not have a
/// contact. The functions do not refer to `scene`.
[[nodiscard]] std::vector<Mistake> contact_mistakes(const scene::Scene& scene);
/// The possible mistakes in [shear], for a scene that has it.
[[nodiscard]] std::vector<Mistake> shear_mistakes(const scene::Scene& scene);

} // namespace edgeproof::diagnose
