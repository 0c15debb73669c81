// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/ledger/claim.hpp"
#include "edgeproof/precision/error.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace edgeproof::io {
class TomlSection;
}

namespace edgeproof::audit {

struct Ledger;

/// Reads the definitions in a ledger's [define]; their bodies may use each other and the parameters
/// of any family. Throws InputError with the file and the line.
[[nodiscard]] std::vector<Vocabulary::Definition> read_definitions(const Ledger& ledger,
                                                                   const io::TomlSection& table);

/// Returns all names that the formulas of a claim may use: those of an evaluated scene, the
/// parameters of its family, its free variables, the names not defined in print, its own
/// definitions, and then the ledger's.
[[nodiscard]] Vocabulary vocabulary_of(const Ledger& ledger, const Claim& claim);

/// The names that formulas may use in every scene, in addition to the parameters.
[[nodiscard]] const std::vector<std::string>& scene_symbols();
/// The names for scenes with friction only: the sizes of the slip zones and the edges of the stick
/// zone -stick_b < x < stick_a.
[[nodiscard]] const std::vector<std::string>& slip_symbols();
/// True for a coefficient of q under full stick (right_s0, ...), which a scene with friction does
/// not have.
[[nodiscard]] bool is_full_stick_symbol(std::string_view name);
[[nodiscard]] const std::vector<std::pair<std::string, unsigned>>& scene_functions();

/// For a name that is not available in formulas: its usual meaning in the literature, if that is a
/// part of mechanics which formulas write otherwise: "stress below the surface" for tau_max,
/// "friction" for mu, a "point contact" for sphere. Nothing for any other name.
[[nodiscard]] std::optional<std::string_view> outside_of_scope(std::string_view name);

/// Returns the same error; for an unknown name outside the scope, it adds what is computed.
[[nodiscard]] InputError with_scope(const InputError& error);

} // namespace edgeproof::audit
