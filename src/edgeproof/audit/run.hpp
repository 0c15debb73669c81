// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/audit/ledger/ledger.hpp"
#include "edgeproof/audit/sample/audit_context.hpp"
#include "edgeproof/precision/real.hpp"

#include <cstddef>
#include <functional>
#include <optional>
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
    /// The treatment of errors that are found in a claim only when it is checked.
    ClaimErrors errors = ClaimErrors::thrown;
};

/// Runs the claims of a ledger whose ids match. Results do not depend on the number of threads.
/// Throws InputError if no id matches the pattern, and Interrupted.
[[nodiscard]] AuditResult run_audit(const Ledger& ledger, const AuditOptions& options);

/// True if the text matches a pattern of the shell, with *, ? and [...] (fnmatch(3)).
[[nodiscard]] bool matches(const std::string& pattern, const std::string& text);

/// For each claim that does not hold, computes the later results of the source from that line as it
/// is printed (the ledger's [[later]], and `as_if` of later claims), and adds them to the evidence:
/// `later_results`, a list of {claim, what, comes_to, as_printed}. `as_printed` is true if the
/// computed value agrees with the printed later line or figure: then the error was carried on, or
/// has no effect there. Otherwise the source did not compute the later result from this line.
void add_later_results(AuditResult& result, const AuditContext& context);

/// Returns the clearest numbers that show a refuted claim to be wrong. They are small and whole
/// where possible, so that a reader can check them by hand. (The samples used for a verdict are
/// chosen to find errors, not to show them.) All decimals are rounded from enclosures.
///
/// For a formula, the symbols get small numbers; `printed` and `correct` are the formulas,
/// `printed_value` and `correct_value` their exact values (left out where there is no closed form),
/// and decimals are added. For the reach of an approximation: a distance at which the error is on
/// the other side of the tolerance. Returns nothing for other kinds, or if no counterexample is
/// found.
[[nodiscard]] std::optional<Evidence> clearest_counterexample(const ClaimResult& result,
                                                              const AuditContext& context);

/// The claim or the reading to which a correction refers: the last reading that is refuted, which
/// is the most favourable to the source.
struct SpokenOf {
    const Claim* claim;
    const Outcome* outcome;
};
[[nodiscard]] SpokenOf spoken_of(const ClaimResult& result);

/// The parts of a figure exit(terms, tolerance)/base, or of measure(...)/base.
struct QuotedReach {
    Expr terms;
    Expr tolerance;
    Expr base;
};
[[nodiscard]] std::optional<QuotedReach> quoted_reach(const Claim& claim);

/// Reads "46 %" or "0.03" as a number.
[[nodiscard]] Rational quoted_number(const std::string& text);

} // namespace edgeproof::audit
