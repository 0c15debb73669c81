// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace edgeproof::audit {

/// The names that formulas may use in every scene, in addition to the parameters.
[[nodiscard]] const std::vector<std::string>& scene_symbols();
/// The names for scenes with friction only: the sizes of the slip zones and the edges of the stick
/// zone -stick_b < x < stick_a.
[[nodiscard]] const std::vector<std::string>& slip_symbols();
/// True for a coefficient of q under full stick (right_s0, ...), which a scene with friction does
/// not have.
[[nodiscard]] bool is_full_stick_symbol(std::string_view name);
[[nodiscard]] const std::vector<std::pair<std::string, unsigned>>& scene_functions();

} // namespace edgeproof::audit
