// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/run.hpp"

#include <string>
#include <vector>

namespace edgeproof::cli {

/// Judges the claims of a ledger whose id matches `only` to `digits` digits with `threads` threads
/// (0: as many as the machine has), and shows the progress on stderr. Claims that cannot be judged
/// are among the result's errors. `timed`: also records the processor time of each claim.
[[nodiscard]] audit::AuditResult judged_ledger(const audit::Ledger& ledger, unsigned digits,
                                               int threads, const std::string& only,
                                               bool timed = false);

/// Writes a line on stderr for each claim of a ledger that could not be read or judged. Returns the
/// exit status: 2, or 0 if there are none.
[[nodiscard]] int report_claim_errors(const std::vector<audit::ClaimError>& errors);

} // namespace edgeproof::cli
