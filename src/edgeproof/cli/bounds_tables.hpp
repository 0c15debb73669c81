// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/evidence/evidence.hpp"
#include "edgeproof/report/table.hpp"

#include <string>
#include <vector>

/// What `edgeproof bounds` prints.
namespace edgeproof::cli {

[[nodiscard]] Table case_table(const std::vector<HardCase>& cases,
                               const std::vector<CaseOutcome>& outcomes, unsigned digits);
[[nodiscard]] Table family_table(const std::vector<HardCase>& cases,
                                 const std::vector<CaseOutcome>& outcomes, unsigned digits);
[[nodiscard]] Table count_table(const CountOptions& options, const CountResult& result);
[[nodiscard]] Table honesty_table(const std::vector<HonestyRow>& rows, unsigned digits);
/// All that it takes to see a finding again.
[[nodiscard]] std::string finding_text(const CountFinding& finding);

/// Title, notes, and columns aligned: text to the left, numbers to the right.
[[nodiscard]] std::string aligned_text(const Table& table);

} // namespace edgeproof::cli
