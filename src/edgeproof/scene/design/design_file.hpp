// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/design/best_reach.hpp"
#include "edgeproof/scene/input/scene_file.hpp"

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace edgeproof::scene {

/// The quantity that a design maximises.
enum class DesignObjective {
    first_exit, ///< the first distance at which the error of n terms is the tolerance
    measure,    ///< the total length of the places where it is within the tolerance
    slip_load   ///< the Q/(f P) up to which the slip-zone size by n terms is within the tolerance
};

/// Values that replace those of [design].
struct DesignQuestion {
    std::optional<std::string> maximise;
    std::optional<std::string> tolerance;
    std::optional<std::string> edge; ///< right, left or both
    std::optional<long> terms;
};

/// A scene in which one or two numbers are ranges; the best values are to be found
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
    Exact tolerance;
    std::vector<Edge> edges{Edge::right};
    contact::ReachUnit unit = contact::ReachUnit::fraction;
    Rational part = 1; ///< the part considered, as a fraction of a + b

    [[nodiscard]] std::vector<contact::ParameterRange> ranges() const;
    /// Returns the scene for one value of each parameter. Throws InputError if these values do not
    /// make a valid scene.
    [[nodiscard]] Scene at(const std::vector<Rational>& values) const;
    /// Returns the relative error as a function of the parameters in closed form. An element is
    /// null if there is no closed form; then `why_not` gives the reason, and no proof is possible.
    [[nodiscard]] std::vector<std::unique_ptr<contact::ErrorFamily>>
    errors(std::string& why_not) const;

private:
    friend DesignScene parse_design(std::string_view text, const std::string& file,
                                    const DesignQuestion& asked);
    std::optional<io::TomlSection> top_; ///< the file
};

/// Reads a design. If a scene has no [design], `asked` gives the question, including the tolerance.
/// Throws InputError with file and line.
[[nodiscard]] DesignScene read_design(const std::filesystem::path& file);
[[nodiscard]] DesignScene parse_design(std::string_view text, const std::string& file,
                                       const DesignQuestion& asked = {});

/// Replaces names in a formula by their values in parentheses.
[[nodiscard]] std::string with_names_replaced(std::string_view formula,
                                              const std::map<std::string, std::string>& values);

inline constexpr unsigned most_design_digits = 1000;

struct DesignResult {
    contact::BestReach best;
    /// Empty if everything is proved; otherwise the reason why the result is an estimate.
    std::string missing;
    [[nodiscard]] bool proved() const { return best.proved && missing.empty(); }
    /// The reach for the printed values, proved if `best` is proved.
    std::optional<Ball> printed_reach;
    std::optional<Ball> falls_short; ///< 1 - printed_reach/best
    /// For one parameter: samples of value and reach (or measure), for a picture.
    std::vector<std::pair<double, double>> curve;
};

struct DesignRunOptions {
    contact::DesignOptions search;
    bool curve = false;
};

/// Throws InputError, with the line, for a value that does not make a valid scene; BudgetError if
/// no reach is found; Interrupted.
[[nodiscard]] DesignResult run_design(const DesignScene& design, const DesignRunOptions& options);

} // namespace edgeproof::scene
