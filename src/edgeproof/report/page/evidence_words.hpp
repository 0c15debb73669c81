// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/run.hpp"

#include <string>
#include <string_view>

namespace edgeproof::report {

/// Returns the meaning of a key of evidence: "steps_against" is "steps that go against it".
[[nodiscard]] std::string key_words(std::string_view key);

/// Returns evidence as small tables: numbers are rounded (verdicts.json has all digits), formulas
/// typeset. Parts that the page shows elsewhere (TeX, the clearest counterexample, later results)
/// are left out.
[[nodiscard]] std::string evidence_html(const audit::Evidence& evidence, const audit::Claim& claim,
                                        const audit::PrintedSource& source);

/// Returns a text of the program as HTML, with typeset formulas.
[[nodiscard]] std::string note_html(const std::string& note, const audit::Claim& claim,
                                    const audit::PrintedSource& source);

} // namespace edgeproof::report
