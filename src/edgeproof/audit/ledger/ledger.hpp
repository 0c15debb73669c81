// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/audit/ledger/claim.hpp"
#include "edgeproof/audit/ledger/family.hpp"
#include "edgeproof/audit/ledger/judgement.hpp"
#include "edgeproof/audit/ledger/printed_source.hpp"
#include "edgeproof/precision/error.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace edgeproof::audit {

/// An error in a claim that cannot be read or judged as it is written; it does not affect other
/// claims.
struct ClaimError {
    std::string id; ///< empty if the claim has no id
    InputError error;
};

/// A later result of the source, computed with an earlier line as it is printed there.
struct LaterResult {
    std::string from;  ///< the claim whose printed line is used
    std::string claim; ///< the later claim
    std::string words; ///< a description: "the two-term error at the distance quoted"
    Expr says;         ///< the resulting later formula, with all definitions put in
};

/// A file of printed claims and of the families of scenes at which they are checked.
struct Ledger {
    std::string name;
    std::string source;
    std::string file;
    std::vector<Family> families;
    std::vector<Vocabulary::Definition> definitions;
    std::vector<Claim> claims;
    std::vector<LaterResult> later;
    PrintedSource print;
    std::vector<ClaimError> errors; ///< of the claims left out, in the order of the file

    /// Throws Error if there is no such family.
    [[nodiscard]] const Family& family(std::string_view wanted) const;
    /// Returns the families of a union, which are no unions; of another family itself.
    [[nodiscard]] std::vector<const Family*> members(const Family& family) const;
};

/// The treatment of an error in one claim: it is thrown, or it is stored in `errors` and the claim
/// is left out.
enum class ClaimErrors { thrown, kept };

/// Reads a ledger and checks it completely: keys, kinds, names, formulas, families. Throws
/// InputError with the file and the line for every fault; with ClaimErrors::kept only for faults
/// outside the claims.
[[nodiscard]] Ledger read_ledger(const std::filesystem::path& file,
                                 ClaimErrors errors = ClaimErrors::thrown);
/// Reads a ledger from text; `file` is the name used in errors.
[[nodiscard]] Ledger parse_ledger(std::string_view text, const std::string& file,
                                  ClaimErrors errors = ClaimErrors::thrown);

/// A file of theorems about a claim that Coq checks.
struct TheoremFile {
    std::string path;           ///< as shown, in the ledger's folder: "certificates/EQ18.v"
    bool whole_verdict = false; ///< the theorems prove all of the verdict
    bool accepted = false;      ///< it is recorded that Coq has accepted the theorems
    std::string file;           ///< the path of the file
    std::string problem;        ///< why the theorems do not count; empty if they are accepted
};

/// The result for one claim: the outcome under each reading, and the combined outcome.
struct ClaimResult {
    Claim claim;
    Outcome outcome;
    std::vector<std::pair<std::string, Outcome>> readings;
    std::optional<TheoremFile> certificate; ///< set by certificate::attach_certificates
    std::string fields_sha256;              ///< set by it, too
};

/// The results of an audit, in the order of the ledger.
struct AuditResult {
    std::string ledger;
    std::string source;
    unsigned digits = 0;
    std::vector<ClaimResult> claims;
    std::vector<ClaimError> errors; ///< of selected claims without a result, in order
};

} // namespace edgeproof::audit
