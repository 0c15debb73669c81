// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/contact/design/best_reach.hpp"
#include "edgeproof/scene/input/scene_file.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace edgeproof::scene {

/// The quantity that a design maximises.
enum class DesignObjective {
    first_exit, ///< the first distance at which the error of n terms is the tolerance
    measure     ///< the total length of the places where it is within the tolerance
};

/// A scene in which one number is a range; its best value is to be found (docs/design.md).
class DesignScene {
public:
    std::string file;
    std::string title;
    std::string parameter; ///< its name
    contact::ParameterRange range;
    std::optional<Rational> printed; ///< a value of the parameter to compare with
    DesignObjective objective = DesignObjective::first_exit;
    bool shear = false; ///< of the shear traction instead of the pressure
    std::size_t terms = 1;
    Exact tolerance;
    std::vector<Edge> edges{Edge::right};
    contact::ReachUnit unit = contact::ReachUnit::fraction;
    Rational part = 1; ///< the part considered, as a fraction of a + b

    /// Returns the scene for one value of the parameter. Throws InputError if it does not make a
    /// valid scene.
    [[nodiscard]] Scene at(const Rational& value) const;
    /// Returns the relative error at each edge as a function of the parameter in closed form;
    /// nothing if there is none: then `why_not` gives the reason, and no proof is possible.
    [[nodiscard]] std::vector<contact::ErrorFamily> errors(std::string& why_not) const;

private:
    friend DesignScene parse_design(std::string_view text, const std::string& file,
                                    const std::vector<io::TomlTable>& instead);
    std::optional<io::TomlSection> top_; ///< the file
};

/// Reads a design. `instead`: keys that replace those of the file. Throws InputError with file and
/// line.
[[nodiscard]] DesignScene parse_design(std::string_view text, const std::string& file,
                                       const std::vector<io::TomlTable>& instead = {});

/// Replaces a name in a formula by its value in parentheses.
[[nodiscard]] std::string with_name_replaced(std::string_view formula, std::string_view name,
                                             std::string_view value);

inline constexpr unsigned most_design_digits = 1000;

struct DesignResult {
    contact::BestReach best;
    /// Empty if everything is proved; otherwise the reason why the result is an estimate.
    std::string missing;
    [[nodiscard]] bool proved() const { return best.proved && missing.empty(); }
    /// The reach for the printed value, proved if `best` is proved.
    std::optional<Ball> printed_reach;
    std::optional<Ball> falls_short; ///< 1 - printed_reach/best
};

/// Throws InputError, with the line, for a value that does not make a valid scene; BudgetError if
/// no reach is found; Interrupted.
[[nodiscard]] DesignResult run_design(const DesignScene& design,
                                      const contact::DesignOptions& options);

} // namespace edgeproof::scene
