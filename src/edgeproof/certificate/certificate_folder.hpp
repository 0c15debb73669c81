// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/certificate/certificate.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace edgeproof::certificate {

/// What README.md of a folder of certificates says of it.
struct FolderTitle {
    std::string of;      ///< "the ledger moore-hills"
    std::string things;  ///< that theorems are about: "claims"
    std::string command; ///< the way to make the folder again
    std::string version; ///< of the program
};

/// Writes a folder that `make -C DIR` checks with Coq and Coq-Interval: a file a claim, the files
/// that they are stated in, Makefile, index.csv (a row a theorem, and one a claim that has none)
/// and README.md (what is trusted). Throws InputError for what cannot be written.
void write_certificates(const std::vector<Certificate>& certificates,
                        const std::filesystem::path& folder, const FolderTitle& title);

/// Puts beside each result the certificate that `folder` has of it: only where the file and those
/// that it is stated in are, to the byte, what write_certificates would write now, so that a ledger
/// or a verdict that has changed since has none. `shown`: the folder's name in TheoremFile::path.
void attach_certificates(audit::AuditResult& result, const audit::Ledger& ledger,
                         const std::filesystem::path& folder, const std::string& shown);

} // namespace edgeproof::certificate
