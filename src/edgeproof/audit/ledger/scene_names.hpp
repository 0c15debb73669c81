// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <utility>
#include <vector>

namespace edgeproof::audit {

/// The names that every scene knows in a formula, beside the parameters of its scene.
[[nodiscard]] const std::vector<std::string>& scene_symbols();
[[nodiscard]] const std::vector<std::pair<std::string, unsigned>>& scene_functions();

} // namespace edgeproof::audit
