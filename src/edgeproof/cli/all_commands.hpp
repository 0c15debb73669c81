// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/cli/cli.hpp"

namespace edgeproof::cli {

/// The command of lab. The program edgeproof has only its name and starts edgeproof-lab, so that
/// the build of the program does not wait for lab.
inline constexpr const char* cost_name = "cost";
inline constexpr const char* cost_help =
    "what a value costs by each route: digits reached, evaluations, time";

/// Runs the program with all its commands and returns its exit status.
/// @param argc the number of words
/// @param argv the words
/// @param add_cost null: `cost` is started as the program edgeproof-lab
[[nodiscard]] int run_edgeproof(int argc, char** argv, AddCommand* add_cost);

} // namespace edgeproof::cli
