// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/run.hpp"

#include <vector>

namespace edgeproof::cli {

/// Claims of a ledger that could not be read or judged: a line each on stderr. Returns 2, the exit
/// status, or 0 where there are none.
[[nodiscard]] int report_claim_errors(const std::vector<audit::ClaimError>& errors);

} // namespace edgeproof::cli
