// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/mutation/mutants.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace edgeproof::report {

/// Mutants that were neither refuted nor proved equal to what they were made from.
[[nodiscard]] std::vector<const audit::MutantFate*> survivors(const audit::MutationRun& run);

/// By kind of mutation: made, refuted, equivalent, surviving, and how often the diagnosis gave back
/// the original; then each survivor and each false alarm, a line each.
[[nodiscard]] std::string mutation_text(const audit::MutationRun& run,
                                        const std::vector<std::string>& false_alarms);

/// A row a mutant: claim, kind, verdict, equivalent, named, the two formulas, the note.
[[nodiscard]] std::string mutation_csv(const std::vector<audit::MutantFate>& fates);

/// A run saved: a note that says what it is of, and the rows found so far.
[[nodiscard]] std::string mutation_state(const std::string& of,
                                         const std::vector<audit::MutantFate>& fates);
/// Throws InputError with the line for a text that is no such state, or one of something else.
[[nodiscard]] std::vector<audit::MutantFate>
parse_mutation_state(std::string_view text, const std::string& file, const std::string& of);

} // namespace edgeproof::report
