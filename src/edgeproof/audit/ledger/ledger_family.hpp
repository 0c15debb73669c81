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

} // namespace edgeproof::audit
