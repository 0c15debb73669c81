// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/run.hpp"

#include <vector>

namespace edgeproof::cli {

/// Writes a line on stderr for each claim of a ledger that could not be read or judged. Returns the
/// exit status: 2, or 0 if there are none.
[[nodiscard]] int report_claim_errors(const std::vector<audit::ClaimError>& errors);

} // namespace edgeproof::cli
