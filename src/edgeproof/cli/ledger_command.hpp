// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/run.hpp"

#include <string>
#include <vector>

/// Common parts of the subcommands that judge a ledger.
namespace edgeproof::cli {

/// Judges the claims of a ledger, and shows their number as `what` on stderr. Claims that cannot be
/// judged are among the result's errors.
[[nodiscard]] audit::AuditResult judged_ledger(const audit::Ledger& ledger,
                                               audit::AuditOptions options,
                                               const std::string& what = "claims");
/// Writes a line on stderr for each claim of a ledger that could not be read or judged. Returns the
/// exit status: 2, or 0 if there are none.
[[nodiscard]] int report_claim_errors(const std::vector<audit::ClaimError>& errors);

} // namespace edgeproof::cli
