// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/comparison/injected_mistake.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace edgeproof::comparison {

/// Relative noise of the pressures of the data: normally distributed.
inline constexpr std::array noise_levels{0.0, 1e-6, 1e-4, 1e-2};

/// What became of the data of one mistake at one noise. Right data, of no name, are named where
/// nothing is said of them.
struct SelfTestCount {
    std::size_t cases = 0;  ///< whose mistake moves the data by more than five times the noise
    std::size_t named = 0;  ///< alone, or among those that the data do not tell apart
    std::size_t alone = 0;  ///< under that name and no other
    std::size_t beyond = 0; ///< cases that the noise hides
    /// Another cause was named, and not this one: of the hidden ones, too.
    std::size_t wrong = 0;
};
struct SelfTestRow {
    std::string name;
    std::array<SelfTestCount, noise_levels.size()> at; ///< by noise
};
struct SelfTest {
    std::vector<SelfTestRow> rows;
    std::vector<std::string> misses; ///< a line a case that was not named, or wrongly
    /// Right data count where they are wrongly named, and nowhere else.
    [[nodiscard]] SelfTestCount total() const;
    /// 95 % are named, and none is wrong.
    [[nodiscard]] bool passes() const;
};

/// Injects each mistake into each contact that it makes sense in, writes the data of 120 elements
/// with noise, reads and compares them. `contacts`: names of tested_contacts, all where it is
/// empty; `progress`: contacts done, of how many. Throws Interrupted.
[[nodiscard]] SelfTest
run_self_test(std::uint64_t seed, const std::vector<std::string>& contacts = {},
              const std::function<void(std::size_t, std::size_t)>& progress = {});

} // namespace edgeproof::comparison
