// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "lab/mutation/mutants.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace edgeproof::report {

/// Returns the mutants that survive (MutantFate::survives).
[[nodiscard]] std::vector<const audit::MutantFate*> survivors(const audit::MutationRun& run);

/// Returns, for each kind of mutation, the numbers of mutants made, refuted, equivalent, undecided
/// and surviving, and how often the diagnosis found the original; then a line for each mutant that
/// survives or is undecided, and for each false alarm.
[[nodiscard]] std::string mutation_text(const audit::MutationRun& run,
                                        const std::vector<std::string>& false_alarms);

/// Returns one row per mutant: claim, kind, verdict, equivalent, named, the two formulas, the note.
[[nodiscard]] std::string mutation_csv(const std::vector<audit::MutantFate>& fates);

/// Returns the state of a run: a note that identifies it, and the rows found so far.
[[nodiscard]] std::string mutation_state(const std::string& of,
                                         const std::vector<audit::MutantFate>& fates);
/// Throws InputError with the line for a text that is not such a state, or a state of another run.
[[nodiscard]] std::vector<audit::MutantFate>
parse_mutation_state(std::string_view text, const std::string& file, const std::string& of);

} // namespace edgeproof::report
