// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/audit/run.hpp"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace edgeproof::report {

/// Returns a text of evidence; empty if there is none.
[[nodiscard]] std::string text_in(const nlohmann::ordered_json& evidence, const std::string& key);

/// A correction in the notation of the source, as TeX.
struct Correction {
    std::string what;    ///< "the coefficient of $\\varepsilon^{3/2}$", or empty
    std::string left;    ///< "L_{I,a}": the common left-hand side of both formulas; may be empty
    std::string printed; ///< right-hand sides
    std::string corrected;
};

/// Returns the correction of a refuted formula; nothing if there is no corrected one.
[[nodiscard]] std::optional<Correction> correction_of(const audit::ClaimResult& result,
                                                      const audit::PrintedSource& source);

/// Returns the correction of a refuted sentence, in words with $...$; empty if there is only a
/// counterexample.
[[nodiscard]] std::string correction_in_words(const audit::ClaimResult& result,
                                              const audit::PrintedSource& source);

/// Returns the clearest counterexample in words with $...$, step by step; empty if the evidence has
/// none.
[[nodiscard]] std::vector<std::string> counterexample_steps(const audit::ClaimResult& result,
                                                            const audit::PrintedSource& source);

/// Typesets the formulas in a text of the program: "left.s1 vanishes at 1/2" gets $...$ around its
/// formulas.
[[nodiscard]] std::string note_tex(const std::string& note, const audit::Claim& claim,
                                   const audit::PrintedSource& source);

/// Typesets a number: "1.2e-7" as 1.2 \\cdot 10^{-7}.
[[nodiscard]] std::string number_tex(const std::string& number);

/// The consequence of an erratum, the most serious first.
enum class Weight {
    conclusion, ///< a sentence of the source is wrong
    figure,     ///< a quoted number is wrong
    carried,    ///< a wrong line from which a wrong conclusion or figure was computed
    slip,       ///< a misprint: later results were not computed from the line as printed
    line,       ///< a formula for which the ledger does not state what is computed from it
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

/// Returns "17 errors found. 8 matter (4 change a conclusion, ...); 7 are misprints; what rests on
/// the other 2 formulas is not stated."
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

/// Returns "Section 2.1 The wedge", or "Appendix A ..."; empty if the section is unknown.
[[nodiscard]] std::string section_words(const audit::Claim& claim,
                                        const audit::PrintedSource& source);

/// Returns errata.tex: one complete page for a journal.
[[nodiscard]] std::string errata_tex(const audit::AuditResult& result,
                                     const audit::PrintedSource& source);

} // namespace edgeproof::report
