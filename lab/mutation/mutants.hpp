// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/run.hpp"
#include "edgeproof/formula/expr.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace edgeproof::audit {

/// A correct formula with one error of the kind that a misprint makes.
struct Mutant {
    std::string kind; ///< "sign", "coefficient", "exponent", "a for b", "prime", "factor", ...
    formula::Expr formula;
};

/// The kinds of mutation, in the order of the report: a sign, a coefficient changed by 1 in its
/// last digit, an exponent by 1/2, a for b, an extra prime, a lost factor, left for right, a lost
/// root.
[[nodiscard]] const std::vector<std::string>& mutation_kinds();

/// Returns every mutant of a formula; no expression tree occurs twice or equals the formula's.
/// Shares no code with the edits tried by a diagnosis (audit/diagnosis/edits.cpp).
[[nodiscard]] std::vector<Mutant> mutants_of(const formula::Expr& formula);

/// The result of the check of one mutant.
struct MutantFate {
    std::string claim;
    std::string kind;
    std::string original;
    std::string mutated;
    Verdict verdict = Verdict::undecided;
    bool equivalent = false; ///< proved equal to the original by symbols
    bool named = false;      ///< the diagnosis found the original
    std::string note;        ///< the note of the outcome

    /// True if the mutant is refuted, or found to have no value as it stands.
    [[nodiscard]] bool caught() const {
        return verdict == Verdict::refuted || verdict == Verdict::underspecified;
    }
    /// True if enclosures do not decide: a limit of the program, which accepts no wrong formula.
    [[nodiscard]] bool undecided() const { return verdict == Verdict::undecided && !equivalent; }
    /// True if a wrong formula is accepted.
    [[nodiscard]] bool survives() const { return !caught() && !undecided() && !equivalent; }
};

struct MutationRun {
    std::uint64_t seed = 1;
    std::size_t claims = 0;   ///< value and identity claims that hold
    std::size_t possible = 0; ///< the number of mutants that exist
    AuditResult originals;    ///< the results for the unchanged claims
    std::vector<MutantFate> fates;
};

struct MutationOptions {
    AuditOptions audit;
    std::size_t mutants = 1000; ///< the number to check; fewer if fewer exist
    std::uint64_t seed = 1;
    /// Fates from an earlier run over the same formulas: those mutants are not checked again.
    std::vector<MutantFate> known = {};
    /// Called from time to time, and at an interruption, with all fates found so far; never
    /// concurrently.
    std::function<void(const std::vector<MutantFate>&)> checkpoint = {};
};

/// Breaks the `value` and `identity` claims of a ledger that are confirmed or proved, and checks
/// each mutant in the same way as the claim. Mutants are drawn from all that exist, one from each
/// claim in turn, in an order given by the seed; the result does not depend on the number of
/// threads. Claims with several readings are left out. Throws Interrupted.
[[nodiscard]] MutationRun run_mutants(const Ledger& ledger, const MutationOptions& options);

} // namespace edgeproof::audit
