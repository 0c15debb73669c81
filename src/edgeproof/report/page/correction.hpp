// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/run.hpp"

#include <optional>
#include <string>
#include <vector>

namespace edgeproof::report {

/// A correction in the notation of the source, as TeX.
struct Correction {
    std::string what;    ///< "the coefficient of $\\varepsilon^{3/2}$", or nothing
    std::string left;    ///< "L_{I,a}": what both sides below are said to be; may be empty
    std::string printed; ///< right-hand sides
    std::string corrected;
};

/// Of a refuted formula; nothing where there is no corrected one.
[[nodiscard]] std::optional<Correction> correction_of(const audit::ClaimResult& result,
                                                      const audit::PrintedSource& source);

/// What a reader should have instead of a refuted sentence, in words with $...$; empty if only the
/// counterexample says it.
[[nodiscard]] std::string correction_in_words(const audit::ClaimResult& result,
                                              const audit::PrintedSource& source);

/// The clearest counterexample in words with $...$, a step each; none where the evidence has none.
[[nodiscard]] std::vector<std::string> counterexample_steps(const audit::ClaimResult& result,
                                                            const audit::PrintedSource& source);

/// A text of the program with the names of formulas in it typeset: "left.s1 vanishes at 1/2" with
/// $...$ around what is a formula.
[[nodiscard]] std::string note_tex(const std::string& note, const audit::Claim& claim,
                                   const audit::PrintedSource& source);

/// The number as a reader wants it: "1.2e-7" as 1.2 \\cdot 10^{-7}.
[[nodiscard]] std::string number_tex(const std::string& number);

} // namespace edgeproof::report
