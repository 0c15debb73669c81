// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/run.hpp"

#include <string>

namespace edgeproof::cli {

/// The claims of a ledger whose id matches `only`, judged to `digits` digits by `threads` threads
/// (0: as many as the machine has); how far it is, on stderr. Claims that cannot be judged are
/// among the result's errors. `timed`: with the processor time of each.
[[nodiscard]] audit::AuditResult judged_ledger(const audit::Ledger& ledger, unsigned digits,
                                               int threads, const std::string& only,
                                               bool timed = false);

} // namespace edgeproof::cli
