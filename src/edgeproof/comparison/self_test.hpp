// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/comparison/measures/exact_contact.hpp"
#include "edgeproof/scene/mistakes/scene_mistakes.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

/// Mistakes of users, in the text of a scene (scene/mistakes/scene_mistakes.hpp) and in its written
/// pressures, to test the diagnosis, which has its own suspects.
namespace edgeproof::comparison {

using scene::scene_of;
using scene::SceneKeys;

struct TestedContact {
    std::string name;
    SceneKeys keys;
};
[[nodiscard]] const std::vector<TestedContact>& tested_contacts();

struct ComputedRow {
    double x = 0;
    double p = 0;
    std::optional<double> q = {};
};

/// A simulated program: its contact and its output.
struct Program {
    SceneKeys keys;
    /// The x that the program writes for a place x.
    std::function<double(double)> written_x = {};
    /// p at a place, instead of the contact's own.
    std::function<double(const ExactContact&, double)> p = {};
    /// Changes the rows before they are written.
    std::function<void(std::vector<ComputedRow>&)> rows = {};
    /// Significant digits of p if they are few; -1: binary32; 0: all.
    int digits = 0;
};

struct InjectedMistake {
    std::string name; ///< the name that the diagnosis should give; empty: no mistake
    bool of_shear = false;
    /// Makes the program with the mistake; nothing if the mistake is not possible in the contact.
    std::function<std::optional<Program>(const SceneKeys&)> make;
};
[[nodiscard]] const std::vector<InjectedMistake>& injected_mistakes();

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
