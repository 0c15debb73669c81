// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/cli/cli.hpp"
#include "edgeproof/cli/scene_command.hpp"
#include "edgeproof/report/report.hpp"

#include <cstdio>
#include <exception>
#include <filesystem>
#include <iterator>
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
void run_command(CLI::App& app, const std::vector<std::string>& words) {
    try {
        std::vector<std::string> reversed(words.rbegin(), words.rend() - 1); // as CLI11 takes them
        app.parse(reversed);
    } catch (const CLI::Success& asked) { // --help and --version
        (void)app.exit(asked);
    }
    io::finish_standard_output();
}
} // namespace

int run_program(int argc, char** argv, const std::vector<Command>& commands) {
    int code = 0;
    io::protect_inputs();
    CLI::App app{
        "Contact pressures near an edge, to any number of digits, and printed claims verified",
        "edgeproof"};
    app.require_subcommand(1);
    app.set_version_flag("--version", report::program_lines());
    app.footer(
        "edgeproof help COMMAND shows the help of a command, edgeproof help scene, recipe or "
        "ledger the keys of such a file.\n"
        "Exit status: 0 done, and nothing differs or fails; 1 something does; 2 the input was "
        "bad; 130, 143 interrupted (SIGINT, SIGTERM)");
    for (const Command& command : commands) {
        add_command(app, code, command);
    }
    std::vector<std::string> words(argv, argv + argc);
    const auto is = [&](std::size_t i, std::string_view word) {
        return i < words.size() && words[i] == word;
    };
    if (is(1, "compute")) { // compute SET SCENE, or compute SCENE
        const bool scene = words.size() > 2 && words[2].find_first_of("=.-") != std::string::npos &&
                           !is(2, "--help") && !is(2, "-h");
        if (scene) {
            words[1] = "pressure";
        } else {
            words.erase(words.begin() + 1);
        }
    }
    if (words.size() == 1) {
        words.emplace_back("--help");
    }
    try {
        if (is(1, "help")) { // help COMMAND
            if (is(2, "scene") || is(2, "recipe") || is(2, "ledger")) {
                io::write_output("-", help_of_keys(words[2]));
                return 0;
            }
            words.erase(words.begin() + 1);
            words = with_words(app, words);
            words.emplace_back("--help");
        }
        if (is(1, "--write-manual") && words.size() == 3) { // used by the build
            write_manual(app, std::string(report::program_version), words[2]);
            return 0;
        }
        if (is(1, "--complete")) { // used by the shells
            for (const std::string& word : completions(app, {words.begin() + 2, words.end()})) {
                std::printf("%s\n", word.c_str());
            }
            return 0;
        }
        words = with_words(app, words);
        run_command(app, words);
        return code;
    } catch (const CLI::ParseError& e) {
        say_line(std::string(e.what()) + "; see edgeproof --help");
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

int run_edgeproof(int argc, char** argv, int (*cost)(Options&)) {
    open_standard_streams();
    take_aborts();
    take_signals();
    std::vector<Command> commands(std::begin(scene_commands), std::end(scene_commands));
    commands.insert(commands.end(), {{"design", design},
                                     {"table", table},
                                     {"points", points},
                                     {"verify", verify},
                                     {"check", check},
                                     {"compare", compare},
                                     {"relations", relations},
                                     {"cost", cost}});
    return run_program(argc, argv, commands);
}

} // namespace edgeproof::cli
