// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/conformance/questions/recipe_grid.hpp"

#include <filesystem>
#include <string>
#include <string_view>

namespace edgeproof::conformance {

/// Throws InputError with file and line for malformed input: unknown keys and names, empty grids,
/// ids that occur twice, a question that the contact cannot answer, more than a million questions
/// (recipe_grid.hpp allows more).
[[nodiscard]] Recipe read_recipe(const std::filesystem::path& file);
[[nodiscard]] Recipe parse_recipe(std::string_view text, const std::string& file);

} // namespace edgeproof::conformance
