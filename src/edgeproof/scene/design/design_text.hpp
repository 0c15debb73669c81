// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace edgeproof::scene {

/// Returns a TOML text without the named sections; the line numbers do not change.
[[nodiscard]] std::string without_sections(std::string_view text,
                                           const std::vector<std::string>& names);
/// Replaces `key = { ... }` of a section by `key = "value"`, and each name of `values` in a quoted
/// text of [profile], [load] and [shear] by its value in parentheses.
[[nodiscard]] std::string with_values(std::string_view text,
                                      const std::map<std::string, std::string>& values);
/// Replaces names in a formula by their values in parentheses.
[[nodiscard]] std::string with_names_replaced(std::string_view formula,
                                              const std::map<std::string, std::string>& values);

} // namespace edgeproof::scene
