// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/run.hpp"

#include <optional>
#include <string>
#include <vector>

namespace edgeproof::report {

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

} // namespace edgeproof::report
