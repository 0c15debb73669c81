// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/diagnosis/edits.hpp"
#include "edgeproof/audit/sample/audit_context.hpp"

#include <functional>
#include <optional>

namespace edgeproof::audit {

/// What is wrong with a refuted formula, and what would be right.
struct RefutedFormula {
    formula::Expr printed; ///< as written, definitions not put in
    formula::Expr exact;   ///< what it should equal, as written
    EditAlphabet alphabet;
    /// Whether a formula agrees with the exact one at a few points, to a few digits: cheap.
    std::function<bool(const formula::Expr&)> passes_screening;
    /// proved or confirmed, if that is what it comes out as: the whole check.
    std::function<std::optional<Verdict>(const formula::Expr&)> verdict_of;
    std::optional<formula::Expr> ratio; ///< printed/exact, where it was recognised
    std::optional<formula::Expr>
        derived; ///< the exact formula, where there is a symbolic derivation
};

/// Adds the diagnosis to the outcome: the smallest single edit that makes the formula come out
/// confirmed or proved; failing that the printed formula divided by the ratio, or the derived one.
/// `correct` is set only to a formula that itself came out so.
void diagnose(const RefutedFormula& refuted, Outcome& outcome);

/// The names that may stand for one another in a claim, and the factors that may have been lost:
/// powers of those names, and of a scene's parameters.
[[nodiscard]] EditAlphabet alphabet_for(const Claim& claim, const formula::Expr& printed,
                                        const formula::Expr& exact,
                                        const SceneSpec* scene = nullptr);

} // namespace edgeproof::audit
