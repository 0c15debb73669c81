// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/scene/input/scene_file.hpp"

#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// The catalogue of the mistakes that programs make in the data of a scene. `edgeproof compare` and
/// `edgeproof check` search for the same mistakes and give them the same names.
namespace edgeproof::scene {

struct SceneMistake {
    std::string_view name;   ///< the name of the cause in the output; several mistakes may share it
    std::string what;        ///< in words, without a verb: "the diameter instead of the radius"
    std::string_view advice; ///< what is right
    std::function<void(Scene&)> change; ///< makes the scene that such a program solves
};

/// The possible mistakes in the moduli, the profile and the load. The changed scene need not have a
/// contact. The functions do not refer to `scene`.
[[nodiscard]] std::vector<SceneMistake> contact_mistakes(const Scene& scene);

/// The possible mistakes in [shear], for a scene that has it.
[[nodiscard]] std::vector<SceneMistake> shear_mistakes(const Scene& scene);

/// Mistakes of users in the text of a scene, to test the diagnoses of `edgeproof compare` and
/// `edgeproof check`, are written without the catalogue, which is under test. The keys of a scene
/// file, such as "profile.R" -> "2".
using SceneKeys = std::map<std::string, std::string>;
/// Reads "profile.R=2 load.P=3".
[[nodiscard]] SceneKeys keys_of(const std::string& text);
[[nodiscard]] Scene scene_of(const SceneKeys& keys);

struct InjectedKeys {
    std::string name; ///< the name that a diagnosis should give
    bool of_shear = false;
    /// Returns the changed keys; nothing if the mistake is not possible in the contact.
    std::function<std::optional<SceneKeys>(const SceneKeys&)> change;
};
[[nodiscard]] const std::vector<InjectedKeys>& injected_keys();

/// The results of a test of a diagnosis: mistakes are put into right data, with noise, and the
/// causes that are named are counted. Here for one mistake at one level of noise. Correct data have
/// no name, and count as named if no cause is reported.
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
