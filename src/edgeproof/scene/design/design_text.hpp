// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace edgeproof::scene {

/// A TOML text with the named sections left out; its lines keep their numbers.
[[nodiscard]] std::string without_sections(std::string_view text,
                                           const std::vector<std::string>& names);
/// `key = { ... }` of a section with `key = "value"` in its place, and each name of `values` in a
/// quoted text of [profile], [load] and [shear] with its value in parentheses.
[[nodiscard]] std::string with_values(std::string_view text,
                                      const std::map<std::string, std::string>& values);
/// Names in a formula with what stands for them.
[[nodiscard]] std::string with_names_replaced(std::string_view formula,
                                              const std::map<std::string, std::string>& values);

} // namespace edgeproof::scene
