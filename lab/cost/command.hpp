// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <CLI/CLI.hpp>

namespace edgeproof::cli {

/// The command of the program edgeproof-lab, which edgeproof starts
/// (edgeproof/cli/cli.hpp).
void add_cost(CLI::App& app, int& code);

} // namespace edgeproof::cli
