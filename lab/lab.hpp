// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/report/tables/table.hpp"

#include <CLI/CLI.hpp>

#include <string>

/// The commands of the program edgeproof-lab, which edgeproof starts
/// (edgeproof/cli/all_commands.hpp):
///   counts/      values drawn by a seed, counted, and compared with second routes
///   cost/        the cost of a value
///   commands/    bounds and cost
namespace edgeproof::cli {

void add_bounds(CLI::App& app, int& code);
void add_cost(CLI::App& app, int& code);

/// Returns title, notes and aligned columns: text to the left, numbers to the right.
[[nodiscard]] std::string aligned_text(const report::Table& table);

} // namespace edgeproof::cli
