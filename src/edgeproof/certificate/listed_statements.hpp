// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/certificate/parts.hpp"

#include <array>
#include <span>
#include <string_view>

namespace edgeproof::certificate {

/// Whether a scene is one that a listed theorem is about.
namespace listed_scenes {

[[nodiscard]] bool tilted_wedge(const SceneSpec& scene);
[[nodiscard]] bool tilted_to_the_left(const SceneSpec& scene);
[[nodiscard]] bool beyond_the_flat(const SceneSpec& scene);
[[nodiscard]] bool within_the_flat(const SceneSpec& scene);
[[nodiscard]] bool force_alone(const SceneSpec& scene);
[[nodiscard]] bool tension_alone(const SceneSpec& scene);
[[nodiscard]] bool tilted_punch(const SceneSpec& scene);
[[nodiscard]] bool power_law(const SceneSpec& scene);
[[nodiscard]] bool symmetric(const SceneSpec& scene);
[[nodiscard]] bool power_law_or_rounded(const SceneSpec& scene);
[[nodiscard]] bool non_symmetric(const SceneSpec& scene);
[[nodiscard]] bool wedge_or_power_law_under_force(const SceneSpec& scene);
[[nodiscard]] bool wedge_under_force(const SceneSpec& scene);
[[nodiscard]] bool under_a_force(const SceneSpec& scene);
[[nodiscard]] bool parabola_in_plane_strain(const SceneSpec& scene);
[[nodiscard]] bool any_contact(const SceneSpec& scene);

} // namespace listed_scenes

/// In place of a unit: the values grow without bound, and the places are to the right of x = 0.
inline constexpr std::string_view growing = "growing";

/// The content of a claim, in the syntax of ledgers: "gp" is the slope of a tilted punch. Two
/// formulas are equal if they are the same tree, with the definitions of the ledger put in.
struct Said {
    std::string_view of = ""; ///< of a series: the edge
    /// The limit, or the sense of a monotone claim; ">" and "<" as in signs_of_terms().
    std::string_view says = "";
    /// A parameter of the family, or a place that the claim varies; of an order, its `factor`.
    std::string_view along = "";
    std::string_view unit = ""; ///< this parameter, divided by `unit`, ends at `end`
    double end = 0;
    std::string_view where = "";
    /// Where the values of a place lie that the claim itself varies; a limit is taken at `from`.
    std::string_view from = "";
    std::string_view to = "";
};

/// A claim for which the Coq files have a theorem: its kind, what it says, and the scenes that the
/// theorem is about.
struct Listed {
    std::string_view kind;
    Said said; ///< in the first reading, if there are several
    bool (*about)(const SceneSpec&);
    std::string_view parameters; ///< of the theorem: "phi a : R"
    std::string_view statement;
    std::string_view proof;
    std::string_view states;
    std::string_view leaves_out = "";
    bool whole = true;
    Verdict verdict = Verdict::confirmed;
    std::array<Said, 2> other_readings = {}; ///< those without `of` and `says` do not exist
};

/// Return all of them: those about pressures, the equation of the contact problem and consistency,
/// and all others. If several are about a claim, the first is stated.
[[nodiscard]] std::span<const Listed> listed_pressures();
[[nodiscard]] std::span<const Listed> listed_statements();

} // namespace edgeproof::certificate
