// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/certificate/certificate.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace edgeproof::certificate {

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
/// verdict has changed since gets no certificate. `shown` is the folder's name in
/// TheoremFile::path.
void attach_certificates(audit::AuditResult& result, const audit::Ledger& ledger,
                         const std::filesystem::path& folder, const std::string& shown);

} // namespace edgeproof::certificate
