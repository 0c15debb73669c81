// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/ledger/claim.hpp"
#include "edgeproof/audit/ledger/ledger.hpp"
#include "edgeproof/audit/ledger/outcome.hpp"

#include <string>
#include <utility>
#include <vector>

namespace edgeproof::audit {

/// What was found of one claim: the outcome under each reading, and what follows from all.
struct ClaimResult {
    Claim claim;
    Outcome outcome;
    std::vector<std::pair<std::string, Outcome>> readings;
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
