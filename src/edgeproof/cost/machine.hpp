// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <utility>
#include <vector>

namespace edgeproof::cost {

/// Where times were taken, as name and value: processor, cores, compiler, libraries with versions.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> machine();

} // namespace edgeproof::cost
