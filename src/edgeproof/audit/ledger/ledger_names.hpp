// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/ledger/claim.hpp"

#include <vector>

namespace edgeproof::io {
class TomlSection;
}

namespace edgeproof::audit {

struct Ledger;

/// The definitions of a ledger's [define]; the bodies may use each other and the parameters of any
/// family. Throws InputError with the file and the line.
[[nodiscard]] std::vector<Vocabulary::Definition> read_definitions(const Ledger& ledger,
                                                                   const io::TomlSection& table);

/// All names that the formulas of a claim may use: an evaluated scene's, those of its family, its
/// free variables, what is undefined in print, the ledger's definitions and its own, which come
/// first.
[[nodiscard]] Vocabulary vocabulary_of(const Ledger& ledger, const Claim& claim);

} // namespace edgeproof::audit
