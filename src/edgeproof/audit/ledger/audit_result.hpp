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

/// Theorems about a claim that Coq checks: the file that states them, seen from the ledger's
/// folder.
struct TheoremFile {
    std::string path;           ///< as it is shown: "certificates/EQ18.v"
    bool whole_verdict = false; ///< they say all that the verdict does, not part of it
    std::string file;           ///< where it is
};

/// What was found of one claim: the outcome under each reading, and what follows from all.
struct ClaimResult {
    Claim claim;
    Outcome outcome;
    std::vector<std::pair<std::string, Outcome>> readings;
    std::optional<TheoremFile>
        certificate;               ///< none unless certificate::attach_certificates found it
    std::optional<double> seconds; ///< of processor time, where that was asked for
};

/// An audit's results, in the order of the ledger.
struct AuditResult {
    std::string ledger;
    std::string source;
    unsigned digits = 0;
    std::vector<ClaimResult> claims;
    std::vector<ClaimError> errors; ///< of claims chosen that have no result, in the ledger's order
};

} // namespace edgeproof::audit
