// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cli/ledger_command.hpp"

#include "edgeproof/cli/cli.hpp"

#include <cstdio>

namespace edgeproof::cli {

audit::AuditResult judged_ledger(const audit::Ledger& ledger, audit::AuditOptions options,
                                 const std::string& what) {
    options.errors = audit::ClaimErrors::kept;
    return with_progress(what, options.progress, [&] { return run_audit(ledger, options); });
}

int report_claim_errors(const std::vector<audit::ClaimError>& errors) {
    std::fflush(stdout);
    for (const audit::ClaimError& e : errors) {
        std::fprintf(stderr, "%s\n", e.error.what());
    }
    return errors.empty() ? 0 : 2;
}

} // namespace edgeproof::cli
