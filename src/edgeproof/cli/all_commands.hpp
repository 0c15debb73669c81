// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/cli/cli.hpp"

namespace edgeproof::cli {

/// A command of lab. The program edgeproof has only its name and starts edgeproof-lab, so that the
/// build of the program does not wait for lab.
struct LabCommand {
    const char* name;
    const char* help;
};
inline constexpr LabCommand lab_bounds{"bounds", "evidence that the bounds hold"};
inline constexpr LabCommand lab_cost{
    "cost", "what a value costs by each route: digits reached, evaluations, time"};

/// Functions that add these commands.
struct LabCommands {
    AddCommand* bounds;
    AddCommand* cost;
};

/// Runs the program with all its commands and returns its exit status.
/// @param argc the number of words
/// @param argv the words
/// @param lab null: the commands of the lab are started as the program edgeproof-lab
[[nodiscard]] int run_edgeproof(int argc, char** argv, const LabCommands* lab);

} // namespace edgeproof::cli
