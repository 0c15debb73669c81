// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cli/all_commands.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <string>
#include <string_view>

namespace edgeproof::cli {
namespace {

template <const LabCommand& command> void add_name_of(CLI::App& app, int& /*code*/) {
    app.add_subcommand(command.name, command.help);
}

/// Replaces this process by edgeproof-lab if the command is one of its own, or if the manual of all
/// commands is to be written. Returns an error message if there is no such program.
std::string start_lab(int argc, char** argv) {
    const std::string_view first = argc > 1 ? argv[1] : "";
    const std::string_view command = first == "help" && argc > 2 ? argv[2] : first;
    const std::array<std::string_view, 3> own{lab_bounds.name, lab_cost.name, "--write-manual"};
    if (std::ranges::find(own, command) == own.end()) {
        return "";
    }
    const std::filesystem::path lab = installed("edgeproof-lab");
    ::execv(lab.c_str(), argv);
    return std::string(command) + " needs the program " + lab.string() +
           ", which does not start (" + std::strerror(errno) + "); scripts/build release builds it";
}

} // namespace

int run_edgeproof(int argc, char** argv, const LabCommands* lab) {
    open_standard_streams();
    take_aborts();
    if (lab == nullptr) {
        if (const std::string problem = start_lab(argc, argv); !problem.empty()) {
            say_at_the_end("edgeproof: " + problem);
            return 2;
        }
    }
    take_signals();
    const LabCommands names{add_name_of<lab_bounds>, add_name_of<lab_cost>};
    const LabCommands& of_lab = lab == nullptr ? names : *lab;
    return run_program(argc, argv,
                       {add_pressure, add_expand, add_extent, add_slip, add_stress,
                        add_displacement, add_plot, add_relations, add_design, add_table,
                        add_points, add_check, add_compare, add_pack, of_lab.bounds, of_lab.cost,
                        add_verify});
}

} // namespace edgeproof::cli
