// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cli/program.hpp"

#include "edgeproof/cli/cli.hpp"
#include "edgeproof/io/output_file.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/precision/message.hpp"
#include "edgeproof/report/text/program_line.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <exception>
#include <filesystem>
#include <initializer_list>
#include <new>
#include <string>
#include <string_view>
#include <vector>

namespace edgeproof::cli {
namespace {

/// Returns one line that is safe for a terminal.
std::string shown(std::string_view message) { return printable(shortened(message, 1500)); }
/// Prints a message that does not concern a file.
void say(std::string_view message) { say_at_the_end("edgeproof: " + shown(message)); }

/// Runs the command, and checks that all its output is written.
void run_command(CLI::App& app, int argc, char** argv) {
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& asked) { // --help and --version
        (void)app.exit(asked);
    }
    io::finish_standard_output();
}

template <const LabCommand& command> void add_name_of(CLI::App& app, int& /*code*/) {
    app.add_subcommand(command.name, command.help);
}

/// Replaces this process by edgeproof-lab if the command is one of its own, or if the manual of all
/// commands is to be written. Returns an error message if there is no such program.
std::string start_lab(int argc, char** argv) {
    const std::string_view first = argc > 1 ? argv[1] : "";
    const std::string_view command = first == "help" && argc > 2 ? argv[2] : first;
    const std::initializer_list<std::string_view> own{lab_bounds.name, lab_cost.name,
                                                      lab_mutate.name, "--write-manual"};
    if (std::ranges::find(own, command) == own.end()) {
        return "";
    }
    const std::filesystem::path lab = installed("edgeproof-lab");
    ::execv(lab.c_str(), argv);
    return std::string(command) + " needs the program " + lab.string() +
           ", which does not start (" + std::strerror(errno) + "); scripts/build release builds it";
}

} // namespace

int run_program(int argc, char** argv, const LabCommands* lab) {
    open_standard_streams();
    take_aborts();
    if (lab == nullptr) {
        if (const std::string problem = start_lab(argc, argv); !problem.empty()) {
            say(problem);
            return 2;
        }
    }
    take_signals();
    int code = 0;
    CLI::App app{
        "Contact pressures near an edge, to any number of digits, and printed claims verified",
        "edgeproof"};
    app.require_subcommand(1);
    app.set_version_flag("--version", report::program_lines());
    app.footer(
        "edgeproof help COMMAND shows the help of a command.\n"
        "Exit status: 0 done, and nothing differs or fails; 1 something does; 2 the input was "
        "bad; 130, 143 interrupted (SIGINT, SIGTERM)");
    const LabCommands names{add_name_of<lab_mutate>, add_name_of<lab_bounds>,
                            add_name_of<lab_cost>};
    const LabCommands& of_lab = lab == nullptr ? names : *lab;
    for (const auto add :
         {add_pressure,     add_expand,    add_extent,     add_slip,      add_stress,
          add_displacement, add_plot,      add_slip_table, add_explain,   add_relations,
          add_design,       add_table,     add_points,     add_check,     add_compare,
          add_pack,         of_lab.mutate, add_certify,    of_lab.bounds, of_lab.cost,
          add_verify}) {
        add(app, code);
    }
    set_help(app);
    std::vector<char*> words(argv, argv + argc);
    std::string help_option = "--help";
    if (argc >= 2 && std::string_view(argv[1]) == "help") { // help COMMAND
        words.erase(words.begin() + 1);
        words.push_back(help_option.data());
        argc = static_cast<int>(words.size());
        const std::string unknown = unknown_on_command_line(app, argc, words.data());
        if (!unknown.empty()) {
            say(unknown);
            return 2;
        }
    }
    argv = words.data();
    try {
        if (argc == 3 && std::string_view(argv[1]) == "--write-manual") { // used by the build
            write_manual(app, std::string(report::program_version), argv[2]);
            return 0;
        }
        run_command(app, argc, argv);
        return code;
    } catch (const CLI::ParseError& e) {
        const std::string unknown = unknown_on_command_line(app, argc, argv);
        say(unknown.empty() ? std::string(e.what()) + "; see edgeproof --help" : unknown);
    } catch (const InputError& e) {
        if (e.file().empty()) {
            say(e.what());
        } else {
            say_at_the_end(e.what());
        }
    } catch (const Interrupted& e) {
        say_at_the_end(e.what());
        return interrupted_status();
    } catch (const Error& e) {
        say_at_the_end(shown(e.what()));
    } catch (const std::bad_alloc&) {
        say("out of memory; ask for fewer digits");
    } catch (const std::filesystem::filesystem_error& e) {
        say("a file or folder cannot be used: " + e.code().message() +
            "; give another name, or a folder that is there");
    } catch (const std::exception& e) {
        say(e.what());
    }
    return 2;
}

} // namespace edgeproof::cli
