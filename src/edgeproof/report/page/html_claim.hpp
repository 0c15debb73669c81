// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/run.hpp"
#include "edgeproof/report/page/html.hpp"

#include <string>

namespace edgeproof::report {

/// A `<span>` with the name of a verdict.
[[nodiscard]] std::string verdict_mark(audit::Verdict verdict);
/// "lines 126–129"; nothing for a formula of no source.
[[nodiscard]] std::string lines_words(const audit::Claim& claim);

/// An entry of the errata list: printed beside corrected. Its own id is "erratum-ID".
[[nodiscard]] std::string erratum_html(const audit::ClaimResult& result, const std::string& section,
                                       const DrawnFigure::Panel* plot);
/// A claim with its evidence, folded; its id is the claim's.
[[nodiscard]] std::string claim_html(const audit::ClaimResult& result, const std::string& section,
                                     const std::string& section_key);
/// Evidence as a table of its keys, nested tables and lists within.
[[nodiscard]] std::string evidence_html(const audit::Evidence& evidence);

} // namespace edgeproof::report
