// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace edgeproof::cost {

/// A random scene to be timed.
struct SampledScene {
    std::string kind; ///< the kind of profile: a scene is compared with those of its kind
    std::string text; ///< in TOML
};

/// Returns the scene with that number; it depends only on the seed and the number. Every second
/// scene has a curved slope: whole, half and odd powers, functions with poles or branch points near
/// the contact or on a knot, symmetric or not, loaded by `a` or by P. The others are those of
/// validation/counts/sample.hpp.
[[nodiscard]] SampledScene sampled_scene(std::uint64_t seed, std::size_t number);

/// A subcommand of the program with its options, run with every scene.
struct ScannedCommand {
    const char* name;
    const char* options;
};
inline constexpr std::array<ScannedCommand, 3> scanned_commands{{
    {"pressure", "--quantity pressure"},
    {"expand", "--quantity coefficients --terms 40"},
    {"extent", "--quantity extent --terms 1,2,3 --tolerance 1%"},
}};

/// One answer: how long it took, and how it ended.
struct TimedAnswer {
    double seconds = 0;   ///< of the processor
    bool stopped = false; ///< ended at the time limit
    std::string failure;  ///< the message if there is no answer; else empty
};

struct SpeedOptions {
    std::uint64_t seed = 1;
    std::size_t scenes = 100;
    std::optional<std::size_t> only; ///< only this scene
    std::vector<unsigned> digits{50, 200};
    unsigned threads = 1; ///< 0: as many as the machine has
    /// Answers a scene, and times it. Called from several threads.
    std::function<TimedAnswer(const SampledScene&, const ScannedCommand&, unsigned digits)> answer;
    std::function<void(std::size_t, std::size_t)> progress = {};
};

/// The scenes of one kind, with the same command and digits.
struct SpeedCell {
    std::string kind;
    std::size_t command = 0; ///< an index into scanned_commands
    unsigned digits = 0;
    struct Scene {
        std::size_t number;
        TimedAnswer answer;
    };
    std::vector<Scene> scenes; ///< the slowest comes first

    [[nodiscard]] double median() const;
    /// Returns the ratio of the slowest to the median.
    [[nodiscard]] double ratio() const;
    [[nodiscard]] std::size_t stopped() const;
    [[nodiscard]] std::size_t failed() const;
};

/// Times every scene with every command at every number of digits. The cell with the greatest ratio
/// comes first. Throws Interrupted.
[[nodiscard]] std::vector<SpeedCell> scan_speed(const SpeedOptions& options);

} // namespace edgeproof::cost
