// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/run.hpp"
#include "edgeproof/report/page/errata.hpp"
#include "edgeproof/report/page/html.hpp"

#include <string>

namespace edgeproof::report {

/// Returns a `<span>` with the name of a verdict.
[[nodiscard]] std::string verdict_mark(audit::Verdict verdict, const std::string& text = "");
/// Returns the printed text of a claim, typeset within a line.
[[nodiscard]] std::string printed_html(const audit::Claim& claim,
                                       const audit::PrintedSource& source);

/// Returns an entry of the errata list: the printed and the corrected formula, the clearest
/// counterexample, the later results. Its id is "erratum-ID" of its first claim.
[[nodiscard]] std::string erratum_html(const Erratum& erratum, const audit::AuditResult& result,
                                       const PageHead& head, const PageFigures& figures);
/// Returns a claim with its evidence, folded; its id is the claim's.
[[nodiscard]] std::string claim_html(const audit::ClaimResult& result, const PageHead& head);

/// Returns evidence as small tables: numbers are rounded (verdicts.json has all digits), formulas
/// typeset. Parts that the page shows elsewhere (TeX, the clearest counterexample, later results)
/// are left out.
[[nodiscard]] std::string evidence_html(const audit::Evidence& evidence, const audit::Claim& claim,
                                        const audit::PrintedSource& source);

/// Returns a text of the program as HTML, with typeset formulas.
[[nodiscard]] std::string note_html(const std::string& note, const audit::Claim& claim,
                                    const audit::PrintedSource& source);

} // namespace edgeproof::report
