// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/report/tables/table.hpp"
#include "lab/counts/binary64_count.hpp"
#include "lab/counts/count.hpp"

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

/// The tables that `edgeproof bounds` prints.
namespace edgeproof::cli {

[[nodiscard]] report::Table
count_table(const validation::CountOptions& options,
            const validation::CountResult<validation::CountFinding>& result);
[[nodiscard]] report::Table binary64_table(const validation::CountResult<std::string>& count);
/// Returns everything that is needed to reproduce a finding.
[[nodiscard]] std::string finding_text(const validation::CountFinding& finding);

/// Returns title, notes and aligned columns: text to the left, numbers to the right.
[[nodiscard]] std::string aligned_text(const report::Table& table);

} // namespace edgeproof::cli
