// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/ledger/family.hpp"

#include <string>
#include <vector>

namespace edgeproof::io {
class TomlSection;
}

namespace edgeproof::audit {

struct Ledger;

/// A [[family]] of a ledger; `above` are the families that stand above it in the file. Throws
/// InputError with `file` and the line.
[[nodiscard]] Family read_family(const io::TomlSection& table, const std::string& file,
                                 const std::vector<Family>& above);

/// Every scene must be one that the mechanics admits; with friction it must have a partial slip.
/// Throws InputError at the line of the family, or of its friction.
void try_drawing(const Family& family, const std::string& file, const std::vector<Family>& all);

/// Every parameter must have an effect: on the contact, on another parameter, or in a formula of a
/// claim over the family. Throws InputError at the line of one that has none.
void refuse_unused_parameters(const Ledger& ledger);

} // namespace edgeproof::audit
