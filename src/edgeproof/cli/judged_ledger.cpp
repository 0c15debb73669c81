// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cli/judged_ledger.hpp"
#include "edgeproof/cli/cli.hpp"

#include <cstdio>

namespace edgeproof::cli {

audit::AuditResult judged_ledger(const audit::Ledger& ledger, unsigned digits, int threads,
                                 const std::string& only, bool timed) {
    audit::AuditOptions options;
    options.digits = digits;
    options.threads = threads;
    options.only = only;
    options.timed = timed;
    options.errors = audit::ClaimErrors::kept;
    Progress progress("claims");
    options.progress = [&](std::size_t done, std::size_t total) { progress(done, total); };
    return run_audit(ledger, options);
}

int report_claim_errors(const std::vector<audit::ClaimError>& errors) {
    std::fflush(stdout);
    for (const audit::ClaimError& e : errors) {
        std::fprintf(stderr, "%s\n", e.error.what());
    }
    return errors.empty() ? 0 : 2;
}

} // namespace edgeproof::cli
