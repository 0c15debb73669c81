// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/report/tables/table.hpp"
#include "lab/counts/binary64_count.hpp"
#include "lab/counts/count.hpp"
#include "lab/validation/hard_cases.hpp"
#include "lab/validation/honesty.hpp"

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

/// The tables that `edgeproof bounds` prints.
namespace edgeproof::cli {

/// `brief`: without the values, their bounds and the faults, so that a row fits on a line.
[[nodiscard]] report::Table case_table(const std::vector<validation::HardCase>& cases,
                                       const std::vector<validation::CaseOutcome>& outcomes,
                                       unsigned digits, bool brief);
[[nodiscard]] report::Table family_table(const std::vector<validation::HardCase>& cases,
                                         const std::vector<validation::CaseOutcome>& outcomes,
                                         unsigned digits);
[[nodiscard]] report::Table
count_table(const validation::CountOptions& options,
            const validation::CountResult<validation::CountFinding>& result);
[[nodiscard]] report::Table binary64_table(const validation::CountResult<std::string>& count);
[[nodiscard]] report::Table honesty_table(const std::vector<validation::HonestyRow>& rows,
                                          unsigned digits);
/// Returns everything that is needed to reproduce a finding.
[[nodiscard]] std::string finding_text(const validation::CountFinding& finding);

/// Adds `bounds speed`, which times scenes.
void add_bounds_speed(CLI::App& bounds, int& code);

/// Returns title, notes and aligned columns: text to the left, numbers to the right.
[[nodiscard]] std::string aligned_text(const report::Table& table);

} // namespace edgeproof::cli
