// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/claim.hpp"
#include "edgeproof/audit/family.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace edgeproof {

/// A file of printed claims and the families of scenes that they are held against.
struct Ledger {
    std::string name;
    std::string source;
    std::string file;
    std::vector<Family> families;
    std::vector<Vocabulary::Definition> definitions;
    std::vector<Claim> claims;

    /// Throws Error if there is none.
    [[nodiscard]] const Family& family(std::string_view wanted) const;
};

/// Reads a ledger and checks all of it: keys, kinds, names, formulas, families. Throws InputError
/// with the file and the line for anything that is not as it should be.
[[nodiscard]] Ledger read_ledger(const std::filesystem::path& file);
/// The same from text; `file` is what errors name.
[[nodiscard]] Ledger parse_ledger(std::string_view text, const std::string& file);

/// The claim with the fields of one of its readings.
[[nodiscard]] Claim under_reading(const Ledger& ledger, const Claim& claim,
                                  const Claim::Reading& reading);

} // namespace edgeproof
