// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/audit/ledger/ledger.hpp"

#include <filesystem>
#include <string>

/// Theorems about claims, which people write and Coq checks (docs/certificates.md).
namespace edgeproof::certificate {

/// Returns the SHA-256 of what a claim states: its fields and readings, the definitions that it
/// uses, and the families of contacts that it is about. Lines and remarks have no effect.
[[nodiscard]] std::string fields_sha256(const audit::Claim& claim, const audit::Ledger& ledger);

/// Sets fields_sha256 of each result and, where index.csv in `folder` lists a file of theorems for
/// the claim, its certificate. The certificate is accepted if the verdict and the fields are those
/// of the index, and if accepted.csv records all its theorems for the file as it is and for the
/// definitions that the folder has now; otherwise the certificate states what differs. A folder
/// without index.csv has no theorems. `shown` is the folder's name in TheoremFile::path.
/// Throws InputError for a malformed index or record.
void attach_certificates(audit::AuditResult& result, const audit::Ledger& ledger,
                         const std::filesystem::path& folder, const std::string& shown);

} // namespace edgeproof::certificate
