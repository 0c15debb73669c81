// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/ledger/claim.hpp"
#include "edgeproof/audit/ledger/family.hpp"
#include "edgeproof/audit/ledger/printed_source.hpp"
#include "edgeproof/precision/error.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace edgeproof::audit {

/// A claim that cannot be read or judged as it is written; the others are.
struct ClaimError {
    std::string id; ///< empty where the claim has none
    InputError error;
};

/// A later result of the source, computed with an earlier line as it is printed there.
struct LaterResult {
    std::string from;   ///< the claim whose printed line is put in
    std::string claim;  ///< the later one
    std::string words;  ///< what it is: "the two-term error at the distance quoted"
    formula::Expr says; ///< what the later one then comes to; all definitions are put in
    std::size_t line = 0;
};

/// A file of printed claims and the families of scenes that they are held against.
struct Ledger {
    std::string name;
    std::string source;
    std::string file;
    std::vector<Family> families;
    std::vector<Vocabulary::Definition> definitions;
    std::vector<Claim> claims;
    std::vector<LaterResult> later;
    PrintedSource print;
    std::vector<ClaimError> errors; ///< of claims that are left out, in the order of the file

    /// Throws Error if there is none.
    [[nodiscard]] const Family& family(std::string_view wanted) const;
};

/// What becomes of an error in one claim: thrown, or kept in `errors` and the claim left out.
enum class ClaimErrors { thrown, kept };

/// Reads a ledger and checks all of it: keys, kinds, names, formulas, families. Throws InputError
/// with the file and the line for anything that is not as it should be; with ClaimErrors::kept
/// only for what is no part of a claim.
[[nodiscard]] Ledger read_ledger(const std::filesystem::path& file,
                                 ClaimErrors errors = ClaimErrors::thrown);
/// The same from text; `file` is what errors name.
[[nodiscard]] Ledger parse_ledger(std::string_view text, const std::string& file,
                                  ClaimErrors errors = ClaimErrors::thrown);

} // namespace edgeproof::audit
