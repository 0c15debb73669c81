// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/agreement/enclosures.hpp"
#include "edgeproof/report/verdicts/verdict_writers.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace edgeproof::report {

std::string bases_table(const audit::AuditResult& result) {
    using audit::ClaimResult;
    std::string text = fmt::format("{:<14}  {:>6}", "verdict", "claims");
    for (const audit::Basis basis : audit::all_bases) {
        text += fmt::format("  {:>10}", name_of(basis));
    }
    text += "  also a theorem of part\n";
    const auto row = [&](std::string_view name, const auto& counted) {
        const auto count = [&](const auto& holds) {
            return std::count_if(result.claims.begin(), result.claims.end(),
                                 [&](const ClaimResult& r) { return counted(r) && holds(r); });
        };
        const auto all = count([](const ClaimResult&) { return true; });
        if (all == 0) {
            return;
        }
        text += fmt::format("{:<14}  {:>6}", name, all);
        for (const audit::Basis basis : audit::all_bases) {
            text += fmt::format("  {:>10}",
                                count([&](const ClaimResult& r) { return basis_of(r) == basis; }));
        }
        text += fmt::format("  {:>22}\n", count([](const ClaimResult& r) {
                                return r.certificate && !r.certificate->whole_verdict;
                            }));
    };
    for (const audit::Verdict verdict : audit::all_verdicts) {
        row(name_of(verdict), [&](const ClaimResult& r) { return r.outcome.verdict == verdict; });
    }
    row("all", [](const ClaimResult&) { return true; });
    return text;
}

} // namespace edgeproof::report
