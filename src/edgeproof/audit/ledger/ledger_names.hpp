// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/ledger/claim.hpp"

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

} // namespace edgeproof::audit
