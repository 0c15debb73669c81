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

/// A right formula broken in one place, as a misprint breaks it.
struct Mutant {
    std::string kind; ///< "sign", "coefficient", "exponent", "a for b", "prime", "factor", ...
    formula::Expr formula;
};

/// The kinds of mutation, in the order in which they are told of: a sign, a coefficient by 1 in its
/// last digit, an exponent by 1/2, a for b, a prime too many, a lost factor, left for right, a lost
/// root.
[[nodiscard]] const std::vector<std::string>& mutation_kinds();

/// Every mutant of a formula, none the same tree as the formula or another mutant. Shares no code
/// with the edits that a diagnosis tries (edits.hpp).
[[nodiscard]] std::vector<Mutant> mutants_of(const formula::Expr& formula);

/// What became of a mutant of a claim.
struct MutantFate {
    std::string claim;
    std::string kind;
    std::string original;
    std::string mutated;
    Verdict verdict = Verdict::undecided;
    bool equivalent = false; ///< proved equal to the original by symbols
    bool named = false;      ///< the diagnosis gives back the original
    std::string note;        ///< of the outcome

    /// Refuted, or found to have no value as it stands: it does not pass for a formula that holds.
    [[nodiscard]] bool caught() const {
        return verdict == Verdict::refuted || verdict == Verdict::underspecified;
    }
};

struct MutationRun {
    std::uint64_t seed = 1;
    std::size_t claims = 0;   ///< value and identity claims that stood the check
    std::size_t possible = 0; ///< mutants that there are
    AuditResult originals;    ///< of the claims as they stand
    std::vector<MutantFate> fates;
};

struct MutationOptions {
    AuditOptions audit;
    std::size_t mutants = 1000; ///< how many, fewer if there are no more
    std::uint64_t seed = 1;
    /// Fates found by an earlier run over the same formulas: those mutants are not checked again.
    std::vector<MutantFate> known = {};
    /// Told now and then, and at a stop, of every fate found so far; one call at a time.
    std::function<void(const std::vector<MutantFate>&)> checkpoint = {};
};

/// Breaks the `value` and `identity` claims of a ledger that are confirmed or proved, and has each
/// mutant checked as the claim was. Mutants are drawn from all that there are, claim by claim in
/// turn, in an order that the seed decides; the result does not depend on the threads. Claims with
/// several readings are left out. Throws Interrupted.
[[nodiscard]] MutationRun run_mutants(const Ledger& ledger, const MutationOptions& options);

} // namespace edgeproof::audit
