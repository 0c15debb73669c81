// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cli/cli.hpp"
#include "edgeproof/io/output_file.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/precision/message.hpp"
#include "edgeproof/report/text/program_line.hpp"
#include "lab/lab.hpp"

#include <exception>
#include <filesystem>
#include <new>
#include <string>
#include <string_view>
#include <vector>

namespace {
/// Returns one line that is safe for a terminal.
std::string shown(std::string_view message) {
    return edgeproof::printable(edgeproof::shortened(message, 1500));
}
/// Prints a message that does not concern a file.
void say(std::string_view message) {
    edgeproof::cli::say_at_the_end("edgeproof: " + shown(message));
}

/// Runs the command, and checks that all its output is written.
void run_command(CLI::App& app, int argc, char** argv) {
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& asked) { // --help and --version
        (void)app.exit(asked);
    }
    edgeproof::io::finish_standard_output();
}
} // namespace

int main(int argc, char** argv) {
    using namespace edgeproof;
    cli::open_standard_streams();
    cli::take_aborts();
    cli::take_signals();
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
    for (const auto add :
         {cli::add_pressure, cli::add_expand,       cli::add_extent,  cli::add_slip,
          cli::add_stress,   cli::add_displacement, cli::add_plot,    cli::add_slip_table,
          cli::add_explain,  cli::add_relations,    cli::add_design,  cli::add_table,
          cli::add_points,   cli::add_check,        cli::add_compare, cli::add_pack,
          cli::add_mutate,   cli::add_certify,      cli::add_bounds,  cli::add_cost,
          cli::add_verify}) {
        add(app, code);
    }
    cli::set_help(app);
    std::vector<char*> words(argv, argv + argc);
    std::string help_option = "--help";
    if (argc >= 2 && std::string_view(argv[1]) == "help") { // help COMMAND
        words.erase(words.begin() + 1);
        words.push_back(help_option.data());
        argc = static_cast<int>(words.size());
        const std::string unknown = cli::unknown_on_command_line(app, argc, words.data());
        if (!unknown.empty()) {
            say(unknown);
            return 2;
        }
    }
    argv = words.data();
    try {
        if (argc == 3 && std::string_view(argv[1]) == "--write-manual") { // used by the build
            cli::write_manual(app, std::string(report::program_version), argv[2]);
            return 0;
        }
        run_command(app, argc, argv);
        return code;
    } catch (const CLI::ParseError& e) {
        const std::string unknown = cli::unknown_on_command_line(app, argc, argv);
        say(unknown.empty() ? std::string(e.what()) + "; see edgeproof --help" : unknown);
    } catch (const InputError& e) {
        if (e.file().empty()) {
            say(e.what());
        } else {
            cli::say_at_the_end(e.what());
        }
    } catch (const Interrupted& e) {
        cli::say_at_the_end(e.what());
        return cli::interrupted_status();
    } catch (const Error& e) {
        cli::say_at_the_end(shown(e.what()));
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
