// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/ledger/claim.hpp"
#include "edgeproof/audit/ledger/ledger.hpp"
#include "edgeproof/audit/ledger/outcome.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace edgeproof::audit {

/// A file of theorems about a claim that Coq checks.
struct TheoremFile {
    std::string path;           ///< as shown, in the ledger's folder: "certificates/EQ18.v"
    bool whole_verdict = false; ///< the theorems prove all of the verdict
    std::string file;           ///< the path of the file
};

/// The result for one claim: the outcome under each reading, and the combined outcome.
struct ClaimResult {
    Claim claim;
    Outcome outcome;
    std::vector<std::pair<std::string, Outcome>> readings;
    std::optional<TheoremFile> certificate; ///< set by certificate::attach_certificates
    std::optional<double> seconds;          ///< processor time, if it was measured
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
