// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/run.hpp"

#include <array>
#include <cstddef>
#include <string>

namespace edgeproof::report {

/// How many claims have each verdict, in the order of `all_verdicts`.
[[nodiscard]] std::array<std::size_t, audit::all_verdicts.size()>
count_verdicts(const audit::AuditResult& result);
/// "61 proved, 30 confirmed, 12 refuted, ..." without those that are zero.
[[nodiscard]] std::string counts_line(const audit::AuditResult& result);

/// A row a verdict that occurs: how many claims have it, and on what these rest (audit::Basis), in
/// columns of spaces; and beside them those of which a theorem says part (`certificate`).
[[nodiscard]] std::string bases_table(const audit::AuditResult& result);

/// Where the processor time went: a row a claim that was timed, the dearest first, with its share
/// of all of them and what its samples tell: at how many the printed formula is refuted and which
/// is the first, or at which it agrees worst, and to how many digits the first half of them agrees.
[[nodiscard]] std::string profile_table(const audit::AuditResult& result);

/// The results as text; each is the same to the byte for the same results, times aside.
[[nodiscard]] std::string verdicts_json(const audit::AuditResult& result);
[[nodiscard]] std::string verdicts_csv(const audit::AuditResult& result);
[[nodiscard]] std::string verdicts_markdown(const audit::AuditResult& result);
/// A longtable for LaTeX's `\input`, with its own preamble notes as comments.
[[nodiscard]] std::string verdicts_latex(const audit::AuditResult& result);

/// For a terminal `width` columns wide: the table, the errata, the counts. `colour` adds ANSI.
[[nodiscard]] std::string verdicts_terminal(const audit::AuditResult& result, std::size_t width,
                                            bool colour);

} // namespace edgeproof::report
