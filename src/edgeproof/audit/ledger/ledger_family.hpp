// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/ledger/family.hpp"

#include <string>
#include <vector>

namespace edgeproof::io {
class TomlSection;
}

namespace edgeproof::audit {

/// A [[family]] of a ledger; `above` are the families that stand above it in the file. Throws
/// InputError with `file` and the line.
[[nodiscard]] Family read_family(const io::TomlSection& table, const std::string& file,
                                 const std::vector<Family>& above);

/// Every scene must be one that the mechanics admits. Throws InputError at the family's line.
void try_drawing(const Family& family, const std::string& file, const std::vector<Family>& all);

} // namespace edgeproof::audit
