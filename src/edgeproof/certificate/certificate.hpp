// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/ledger/ledger.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace edgeproof::certificate {

/// The theorems of one claim as a file for Coq, or the reason why there are none. Nothing here is
/// trusted: the file contains a statement and a proposed proof, and Coq's kernel accepts or rejects
/// it.
struct Certificate {
    std::string id;      ///< of the claim
    std::string verdict; ///< the verdict that `verify` gives
    /// The name of each theorem, and its statement in words.
    struct Theorem {
        std::string name;
        std::string states;
    };
    std::vector<Theorem> theorems; ///< empty: there is no file
    bool whole_verdict = false;    ///< the theorems state everything that the verdict does
    std::string leaves_out;        ///< the part that is not stated, or why there is no theorem
    std::string file;              ///< the file's name: "EQ18.v"
    std::string text;              ///< the file's content
};

/// Returns the theorems that can be stated about a claim as printed (its readings are left out).
[[nodiscard]] Certificate certify(const audit::ClaimResult& result, const audit::Ledger& ledger);

/// Returns the name in Coq for an id: "EQ30_L" for "EQ30.L".
[[nodiscard]] std::string coq_name(const std::string& id);

/// The facts that the README.md of a folder of certificates contains.
struct FolderTitle {
    std::string of;      ///< the subject: "the ledger moore-hills"
    std::string things;  ///< what the theorems are about: "claims"
    std::string command; ///< the command that writes the folder again
    std::string version; ///< the program's version
};

/// Writes a folder that `make -C DIR` checks with Coq and Coq-Interval: a file for each claim, the
/// Coq files that they import, Makefile, index.csv (a row for each theorem, and one for each claim
/// without a theorem) and README.md (what is trusted). Throws InputError if a file cannot be
/// written.
void write_certificates(const std::vector<Certificate>& certificates,
                        const std::filesystem::path& folder, const FolderTitle& title);

/// Adds to each result its certificate from `folder`, if the claim's file and the Coq files that it
/// imports are byte for byte those that write_certificates would write now. A claim whose text or
/// verdict has changed since gets no certificate. The certificate is `accepted` if accepted.csv in
/// the folder records all its theorems. `shown` is the folder's name in TheoremFile::path.
void attach_certificates(audit::AuditResult& result, const audit::Ledger& ledger,
                         const std::filesystem::path& folder, const std::string& shown);

} // namespace edgeproof::certificate
