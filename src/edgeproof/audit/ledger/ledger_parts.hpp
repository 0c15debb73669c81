// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/audit/ledger/claim.hpp"
#include "edgeproof/audit/ledger/family.hpp"
#include "edgeproof/precision/error.hpp"

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace edgeproof::io {
class TomlSection;
}

namespace edgeproof::audit {

struct Ledger;

/// Reads a [[family]] of a ledger; `above` holds the families before it in the file. Throws
/// InputError with `file` and the line.
[[nodiscard]] Family read_family(const io::TomlSection& table, const std::string& file,
                                 const std::vector<Family>& above);

/// Draws all scenes of a family: each must be a possible contact and, with friction, must have a
/// partial slip. Throws InputError at the line of the family, or of its friction.
void try_drawing(const Family& family, const std::string& file, const std::vector<Family>& all);

/// Every parameter must have an effect: on the contact, on another parameter, or in a formula of a
/// claim over the family. Throws InputError at the line of a parameter without effect.
void refuse_unused_parameters(const Ledger& ledger);

/// Adds the words of a text: letters, digits and _.
void collect_words(std::string_view text, std::set<std::string>& into);

/// Reads the definitions in a ledger's [define]; their bodies may use each other and the parameters
/// of any family. Throws InputError with the file and the line.
[[nodiscard]] std::vector<Vocabulary::Definition> read_definitions(const Ledger& ledger,
                                                                   const io::TomlSection& table);

/// Returns all names that the formulas of a claim may use: those of an EnclosedSample, the
/// parameters of its family, its free variables, the names not defined in print, its own
/// definitions, and then the ledger's.
[[nodiscard]] Vocabulary vocabulary_of(const Ledger& ledger, const Claim& claim);

/// The names and functions that formulas may use in every scene, in addition to the parameters.
[[nodiscard]] const formula::Symbols& scene_names();
/// True for the names for scenes with friction only: the sizes of the slip zones and the edges of
/// the stick zone -stick_b < x < stick_a.
[[nodiscard]] bool is_slip_symbol(std::string_view name);
/// True for the greatest stresses and their places, such as "greatest_tau_max" and
/// "greatest_tau_max_z"; "axis_tau_max" on the axis of a body of revolution.
[[nodiscard]] bool is_greatest(std::string_view name);
/// True for these, and for stresses at a place and a depth, "tau_max" of tau_max(x, z).
[[nodiscard]] bool is_stress(std::string_view name);

} // namespace edgeproof::audit
