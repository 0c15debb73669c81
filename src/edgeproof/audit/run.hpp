// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/ledger/audit_result.hpp"
#include "edgeproof/audit/sample/audit_context.hpp"

#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace edgeproof::audit {

struct AuditOptions {
    unsigned digits = 50;
    int threads = 0;        ///< 0: one for each processor
    std::string only = "*"; ///< a pattern of ids, with * and ? as in a shell
    std::function<void(std::size_t done, std::size_t total)> progress; ///< called from any thread
    bool timed = false; ///< measure the processor time of each claim
    /// The treatment of errors that are found in a claim only when it is checked.
    ClaimErrors errors = ClaimErrors::thrown;
};

/// Runs the claims of a ledger whose ids match. Results do not depend on the number of threads.
/// Throws InputError if no id matches the pattern, and Interrupted.
[[nodiscard]] AuditResult run_audit(const Ledger& ledger, const AuditOptions& options);

/// True if the text matches a pattern with * and ?.
[[nodiscard]] bool matches(std::string_view pattern, std::string_view text);

} // namespace edgeproof::audit
