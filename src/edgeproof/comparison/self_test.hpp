// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/comparison/injected_mistake.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace edgeproof::comparison {

/// Relative, normally distributed noise of the pressures of the data.
inline constexpr std::array noise_levels{0.0, 1e-6, 1e-4, 1e-2};

/// The results for one mistake at one level of noise. Correct data have no name, and count as named
/// if no cause is reported.
struct SelfTestCount {
    std::size_t cases = 0;  ///< whose mistake changes the data by more than five times the noise
    std::size_t named = 0;  ///< found, alone or among causes that the data do not distinguish
    std::size_t alone = 0;  ///< found under that name only
    std::size_t beyond = 0; ///< cases that the noise hides
    /// Another cause was found, but not this one; hidden cases are included.
    std::size_t wrong = 0;
};
struct SelfTestRow {
    std::string name;
    std::array<SelfTestCount, noise_levels.size()> at; ///< by noise
};
struct SelfTest {
    std::vector<SelfTestRow> rows;
    std::vector<std::string> misses; ///< one line for each case not found, or found wrongly
    /// The sum over the mistakes. Correct data are counted only if a cause is reported for them.
    [[nodiscard]] SelfTestCount total() const;
    /// True if 95 % are found, and none wrongly.
    [[nodiscard]] bool passes() const;
};

/// Injects each mistake into each contact where it is possible, writes the data of 120 elements
/// with noise, reads and compares them. `contacts`: names of tested_contacts, all if empty;
/// `progress` is called with the number of contacts done, and their total. Throws Interrupted.
[[nodiscard]] SelfTest
run_self_test(std::uint64_t seed, const std::vector<std::string>& contacts = {},
              const std::function<void(std::size_t, std::size_t)>& progress = {});

} // namespace edgeproof::comparison
