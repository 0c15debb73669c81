// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/run.hpp"

#include <string>
#include <string_view>

namespace edgeproof::report {

/// What a key of evidence says, in words: "steps_against" is "steps that go against it".
[[nodiscard]] std::string key_words(std::string_view key);

/// Evidence as small tables, numbers rounded for reading (verdicts.json has all digits), formulas
/// typeset. What the page shows in its own words elsewhere (TeX, the clearest counterexample, later
/// results) is left out.
[[nodiscard]] std::string evidence_html(const audit::Evidence& evidence, const audit::Claim& claim,
                                        const audit::PrintedSource& source);

/// A text of the program as HTML, formulas in it typeset.
[[nodiscard]] std::string note_html(const std::string& note, const audit::Claim& claim,
                                    const audit::PrintedSource& source);

} // namespace edgeproof::report
