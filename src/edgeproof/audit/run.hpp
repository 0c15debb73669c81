// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/ledger/ledger.hpp"
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
    /// Called from any thread.
    std::function<void(std::size_t done, std::size_t total)> progress = {};
    bool timed = false; ///< measure the processor time of each claim
    /// The treatment of errors that are found in a claim only when it is checked.
    ClaimErrors errors = ClaimErrors::thrown;
};

/// Runs the claims of a ledger whose ids match. Results do not depend on the number of threads.
/// Throws InputError if no id matches the pattern, and Interrupted.
[[nodiscard]] AuditResult run_audit(const Ledger& ledger, const AuditOptions& options);

/// True if the text matches a pattern with * and ?.
[[nodiscard]] bool matches(std::string_view pattern, std::string_view text);

/// For each claim that does not hold, computes the later results of the source from that line as it
/// is printed (the ledger's [[later]], and `as_if` of later claims), and adds them to the evidence:
/// `later_results`, a list of {claim, what, comes_to, as_printed}. `as_printed` is true if the
/// computed value agrees with the printed later line or figure: then the error was carried on, or
/// has no effect there. Otherwise the source did not compute the later result from this line.
void add_later_results(AuditResult& result, const AuditContext& context);

} // namespace edgeproof::audit
