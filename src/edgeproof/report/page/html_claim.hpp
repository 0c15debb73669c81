// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/run.hpp"
#include "edgeproof/report/page/errata.hpp"
#include "edgeproof/report/page/html.hpp"

#include <string>

namespace edgeproof::report {

/// A `<span>` with the name of a verdict.
[[nodiscard]] std::string verdict_mark(audit::Verdict verdict);
/// "lines 126–129"; nothing for a formula of no source.
[[nodiscard]] std::string lines_words(const audit::Claim& claim);
/// The printed text of a claim, typeset in a line.
[[nodiscard]] std::string printed_html(const audit::Claim& claim,
                                       const audit::PrintedSource& source);

/// An entry of the errata list: printed beside corrected, the clearest counterexample, what was
/// computed with it. Its own id is "erratum-ID" of its first claim.
[[nodiscard]] std::string erratum_html(const Erratum& erratum, const audit::AuditResult& result,
                                       const PageHead& head, const PageFigures& figures);
/// A claim with its evidence, folded; its id is the claim's.
[[nodiscard]] std::string claim_html(const audit::ClaimResult& result, const PageHead& head,
                                     const std::string& section_key);

} // namespace edgeproof::report
