// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <cstddef>
#include <string>
#include <vector>

/// The results of a test of a diagnosis: mistakes are put into right data, with noise, and the
/// causes that are named are counted. `edgeproof compare` and `edgeproof check` share it.
namespace edgeproof::scene {

/// The results for one mistake at one level of noise. Correct data have no name, and count as named
/// if no cause is reported.
struct MistakeCount {
    std::size_t cases = 0;  ///< whose mistake changes the data by more than five times the noise
    std::size_t named = 0;  ///< found, alone or among causes that the data do not distinguish
    std::size_t alone = 0;  ///< found under that name only
    std::size_t beyond = 0; ///< cases that the noise hides
    /// Another cause was found, but not this one; hidden cases are included.
    std::size_t wrong = 0;
};
struct MistakeRow {
    static constexpr std::size_t most_levels = 5;
    std::string name;
    std::array<MistakeCount, most_levels> at = {}; ///< by noise
};

/// One diagnosis of data with a mistake.
struct MistakeTrial {
    std::string mistake; ///< its name; empty: the data are right
    std::string contact;
    std::size_t level = 0;          ///< of the noise
    std::vector<std::string> named; ///< the names of the causes reported
    bool hidden = false;            ///< the noise hides the mistake
    bool misled = false;            ///< a cause is reported for data that are right
    std::string measured = {};      ///< for the line of a miss
};

struct MistakeCounts {
    MistakeCounts() = default;
    explicit MistakeCounts(std::vector<double> noise_levels) : noise(std::move(noise_levels)) {}

    std::vector<double> noise; ///< relative, at most MistakeRow::most_levels
    std::vector<MistakeRow> rows;
    std::vector<std::string> misses; ///< one line for each case not found, or found wrongly
    std::size_t contacts = 0;

    void count(const MistakeTrial& trial);
    /// The sum over the mistakes. Correct data are counted only if a cause is reported for them.
    [[nodiscard]] MistakeCount total() const;
    /// True if this share is found, in percent, and none wrongly.
    [[nodiscard]] bool passes(std::size_t percent = 95) const;
    /// A table with a row for each mistake, the misses, and a line with the sums.
    [[nodiscard]] std::string text() const;
};

} // namespace edgeproof::scene
