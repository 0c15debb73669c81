// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/mutants.hpp"

#include <string>
#include <vector>

namespace edgeproof {

/// Mutants that were neither refuted nor proved equal to what they were made from.
[[nodiscard]] std::vector<const MutantFate*> survivors(const MutationRun& run);

/// By kind of mutation: made, refuted, equivalent, surviving, and how often the diagnosis gave back
/// the original; then each survivor and each false alarm, a line each.
[[nodiscard]] std::string mutation_text(const MutationRun& run,
                                        const std::vector<std::string>& false_alarms);

/// A row a mutant: claim, kind, verdict, equivalent, named, the two formulas, the note.
[[nodiscard]] std::string mutation_csv(const MutationRun& run);

} // namespace edgeproof
