// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cli/cli.hpp"
#include "edgeproof/io/output_file.hpp"
#include "edgeproof/io/own_file.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/precision/message.hpp"
#include "edgeproof/report/text/program_line.hpp"

#include <exception>
#include <filesystem>
#include <new>
#include <string>
#include <string_view>
#include <vector>

namespace edgeproof::cli {
namespace {

/// Returns one line that is safe for a terminal.
std::string safe_line(std::string_view message) { return printable(shortened(message, 1500)); }
/// Prints a message that does not concern a file.
void say_line(std::string_view message) { say_at_the_end("edgeproof: " + safe_line(message)); }

/// Runs the command, and checks that all its output is written.
void run_command(CLI::App& app, int argc, char** argv) {
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& asked) { // --help and --version
        (void)app.exit(asked);
    }
    io::finish_standard_output();
}
} // namespace

int run_program(int argc, char** argv, std::initializer_list<AddCommand*> commands) {
    int code = 0;
    io::protect_inputs();
    CLI::App app{
        "Contact pressures near an edge, to any number of digits, and printed claims verified",
        "edgeproof"};
    app.require_subcommand(1);
    app.set_version_flag("--version", report::program_lines());
    app.footer(
        "edgeproof help COMMAND shows the help of a command.\n"
        "Exit status: 0 done, and nothing differs or fails; 1 something does; 2 the input was "
        "bad; 130, 143 interrupted (SIGINT, SIGTERM)");
    for (AddCommand* const add : commands) {
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
            say_line(unknown);
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
        say_line(unknown.empty() ? std::string(e.what()) + "; see edgeproof --help" : unknown);
    } catch (const InputError& e) {
        if (e.file().empty()) {
            say_line(e.what());
        } else {
            say_at_the_end(e.what());
        }
    } catch (const Interrupted& e) {
        say_at_the_end(e.what());
        return interrupted_status();
    } catch (const Error& e) {
        say_at_the_end(safe_line(e.what()));
    } catch (const std::bad_alloc&) {
        say_line("out of memory; ask for fewer digits, points or scenes");
    } catch (const std::filesystem::filesystem_error& e) {
        say_line("a file or folder cannot be used: " + e.code().message() +
                 "; give another name, or a folder that is there");
    } catch (const std::exception& e) {
        say_line(e.what());
    }
    return 2;
}

} // namespace edgeproof::cli
