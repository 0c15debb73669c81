// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cli/cli.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <string>
#include <string_view>

namespace edgeproof::cli {
namespace {

void add_name_of_cost(CLI::App& app, int& /*code*/) { app.add_subcommand(cost_name, cost_help); }

/// Replaces this process by edgeproof-lab if the command is `cost`, or if the manual of all
/// commands is to be written. Returns an error message if there is no such program.
std::string start_lab(int argc, char** argv) {
    const std::string_view first = argc > 1 ? argv[1] : "";
    const std::string_view command = first == "help" && argc > 2 ? argv[2] : first;
    if (command != cost_name && command != "--write-manual") {
        return "";
    }
    const std::filesystem::path lab = installed("edgeproof-lab");
    ::execv(lab.c_str(), argv);
    return std::string(command) + " needs the program " + lab.string() +
           ", which does not start (" + std::strerror(errno) + "); scripts/build release builds it";
}

} // namespace

int run_edgeproof(int argc, char** argv, AddCommand* add_cost) {
    open_standard_streams();
    take_aborts();
    if (add_cost == nullptr) {
        if (const std::string problem = start_lab(argc, argv); !problem.empty()) {
            say_at_the_end("edgeproof: " + problem);
            return 2;
        }
    }
    take_signals();
    return run_program(argc, argv,
                       {add_sets, add_plot, add_design, add_table, add_points, add_verify,
                        add_check, add_compare, add_relations,
                        add_cost == nullptr ? add_name_of_cost : add_cost});
}

} // namespace edgeproof::cli
