// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cli/judged_ledger.hpp"

#include "edgeproof/cli/cli.hpp"

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

} // namespace edgeproof::cli
