// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/run.hpp"

#include <string>
#include <vector>

namespace edgeproof::report {

/// The consequence of an erratum, the most serious first.
enum class Weight {
    conclusion, ///< a sentence of the source is wrong
    figure,     ///< a quoted number is wrong
    carried,    ///< a wrong line from which a wrong conclusion or figure was computed
    slip,       ///< a misprint: later results were not computed from the line as printed
};

/// One wrong place of the source: the refuted claims about one equation or one sentence.
struct Erratum {
    std::vector<const audit::ClaimResult*> parts;
    std::string number; ///< of the equation; empty for a sentence, or if unknown
    Weight weight = Weight::slip;
};

/// Returns the refuted claims by place, ordered by weight, then as in the ledger.
[[nodiscard]] std::vector<Erratum> errata_of(const audit::AuditResult& result,
                                             const audit::PrintedSource& source);

/// Returns "17 errors: 5 change a conclusion, 3 a figure that is quoted, ..., 7 are
/// misprints."
[[nodiscard]] std::string errata_count(const std::vector<Erratum>& errata);

/// A later result computed with a line as printed (audit/run.hpp).
struct LaterWords {
    std::string claim;
    std::string what;
    std::string comes_to;
    bool as_printed = false;
};
[[nodiscard]] std::vector<LaterWords> later_results_of(const audit::ClaimResult& result);

/// Returns "Eq. (39)", "Section 2.1, line 164", or the claim's id if the place is unknown.
[[nodiscard]] std::string place_words(const audit::Claim& claim,
                                      const audit::PrintedSource& source);

/// Returns errata.tex: one complete page for a journal.
[[nodiscard]] std::string errata_tex(const audit::AuditResult& result,
                                     const audit::PrintedSource& source);

} // namespace edgeproof::report
