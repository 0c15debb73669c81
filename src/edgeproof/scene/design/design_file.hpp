// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/design/design.hpp"
#include "edgeproof/scene/input/scene_file.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace edgeproof::scene {

/// What a design makes as large as it can be.
enum class DesignObjective {
    first_exit, ///< the first distance at which n terms are off by the tolerance
    measure,    ///< the length of all places at which they are not
    slip_load   ///< the Q/(f P) up to which n terms of a slip zone's size are within the tolerance
};

/// What is asked in place of what [design] says.
struct DesignQuestion {
    std::optional<std::string> maximise;
    std::optional<std::string> tolerance;
    std::optional<std::string> edge; ///< right, left or both
    std::optional<long> terms;
};

/// A scene in which one or two numbers are ranges, and the question which values are best
/// (docs/design.md).
class DesignScene {
public:
    struct Parameter {
        std::string name;
        contact::ParameterRange range;
        std::optional<Rational> printed; ///< a value to compare with
    };
    std::string file;
    std::string title;
    std::vector<Parameter> parameters;
    DesignObjective objective = DesignObjective::first_exit;
    bool shear = false; ///< of the shear traction instead of the pressure
    std::size_t terms = 1;
    formula::Exact tolerance;
    std::vector<contact::Edge> edges{contact::Edge::right};
    contact::ReachUnit unit = contact::ReachUnit::fraction;
    Rational part = 1; ///< of a + b, that is looked at

    [[nodiscard]] std::vector<contact::ParameterRange> ranges() const;
    /// The scene for one value of each parameter. Throws InputError where it makes none.
    [[nodiscard]] Scene at(const std::vector<Rational>& values) const;
    /// The relative error as a function of the parameters in closed form; null where there is none:
    /// `why_not` says so, and no proof can be had.
    [[nodiscard]] std::vector<std::unique_ptr<contact::ErrorFamily>>
    errors(std::string& why_not) const;

private:
    friend DesignScene parse_design(std::string_view text, const std::string& file,
                                    const DesignQuestion& asked);
    std::string scene_text_; ///< without [design] and [parameters]; lines are kept
};

/// A scene without [design] is asked what `asked` says, which then has a tolerance. Throws
/// InputError with file and line.
[[nodiscard]] DesignScene read_design(const std::filesystem::path& file);
[[nodiscard]] DesignScene parse_design(std::string_view text, const std::string& file,
                                       const DesignQuestion& asked = {});

} // namespace edgeproof::scene
