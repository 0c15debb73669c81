// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/comparison/injected_mistake.hpp"
#include "edgeproof/scene/mistakes/scene_mistakes.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace edgeproof::comparison {

/// Relative, normally distributed noise of the pressures of the data.
inline constexpr std::array noise_levels{0.0, 1e-6, 1e-3, 1e-2, 5e-2};

using SelfTestCount = scene::MistakeCount;
using SelfTestRow = scene::MistakeRow;
using SelfTest = scene::MistakeCounts;

/// Injects each mistake into each contact where it is possible, writes the data of 120 elements
/// with noise, reads and compares them. `contacts`: names of tested_contacts, all if empty;
/// `progress` is called with the number of contacts done, and their total. Throws Interrupted.
[[nodiscard]] SelfTest
run_self_test(std::uint64_t seed, const std::vector<std::string>& contacts = {},
              const std::function<void(std::size_t, std::size_t)>& progress = {});

} // namespace edgeproof::comparison
