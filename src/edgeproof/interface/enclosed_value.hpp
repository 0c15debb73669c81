// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/edgeproof.hpp"
#include "edgeproof/scene/scene.hpp"

#include <nlohmann/json.hpp>

#include <string>

/// What the parts of edgeproof.hpp share: the types of the library behind those of the header.
namespace edgeproof {

using Json = nlohmann::ordered_json;
/// Returns JSON in a line; what is not UTF-8 is replaced.
[[nodiscard]] inline std::string json_text(const Json& json) {
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

struct Value::Enclosure {
    scene::BoundedValue value;
};

/// Throws BudgetError for a ball that is not finite: a value is never NaN.
[[nodiscard]] Value value_of(scene::BoundedValue value, unsigned digits);

/// Throws InputError for a number of digits that is not in least ... most.
void require_digits(long digits, long least, long most);

/// The scene behind a Scene.
[[nodiscard]] const scene::Scene& scene_of(const Scene& scene);

} // namespace edgeproof
