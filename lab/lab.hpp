// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <CLI/CLI.hpp>

/// The program's tests of itself: commands of the program edgeproof-lab, which edgeproof starts
/// (edgeproof/cli/all_commands.hpp):
///   counts/      values drawn by a seed, counted, and compared with second routes
///   validation/  hard cases, second routes, claimed and true errors
///   cost/        the cost of a value
///   mutation/    formulas broken on purpose
///   commands/    bounds, cost and mutate
namespace edgeproof::cli {

void add_bounds(CLI::App& app, int& code);
void add_cost(CLI::App& app, int& code);
void add_mutate(CLI::App& app, int& code);

} // namespace edgeproof::cli
