// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <utility>
#include <vector>

namespace edgeproof::cost {

/// Returns the machine as names and values: processor, cores, compiler, libraries with versions.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> machine();

} // namespace edgeproof::cost
