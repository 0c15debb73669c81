// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/run.hpp"
#include "edgeproof/cli/cli.hpp"
#include "edgeproof/cli/commands/check/check_kinds.hpp"
#include "edgeproof/cli/judged_ledger.hpp"
#include "edgeproof/cli/scene_command.hpp"
#include "edgeproof/report/verdicts/verdict_writers.hpp"

#include <algorithm>
#include <cstdio>

namespace edgeproof::cli {

int check_ledger(const std::string& ledger, const std::string& threads) {
    const audit::Ledger formulas = read_ledger(ledger, audit::ClaimErrors::kept);
    if (formulas.claims.empty() && !formulas.errors.empty()) {
        return report_claim_errors(formulas.errors);
    }
    audit::AuditOptions options;
    options.threads = static_cast<int>(threads_of(threads));
    options.errors = audit::ClaimErrors::kept;
    audit::AuditResult result;
    {
        Progress progress("formulas");
        options.progress = [&](std::size_t done, std::size_t total) { progress(done, total); };
        result = run_audit(formulas, options);
    }
    std::fputs(report::verdicts_terminal(result, terminal_width(), stdout_takes_colour()).c_str(),
               stdout);
    const auto wrong = std::count_if(result.claims.begin(), result.claims.end(),
                                     [](const auto& c) { return !holds(c.outcome.verdict); });
    const bool passes = wrong == 0 && result.errors.empty();
    std::printf("%s: %zu formulas, %zu do not hold", passes ? "pass" : "FAIL", result.claims.size(),
                static_cast<std::size_t>(wrong));
    if (!result.errors.empty()) {
        std::printf("; %zu more could not be judged", result.errors.size());
    }
    std::printf("\n");
    const int bad = report_claim_errors(result.errors);
    return bad != 0 ? bad : wrong == 0 ? 0 : 1;
}

} // namespace edgeproof::cli
