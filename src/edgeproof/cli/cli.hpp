// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// The program and its commands, one function each.
#include <CLI/CLI.hpp>

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace edgeproof::cli {

/// The options of a command and their values, by the first of their names ("scene", "--out").
struct Options {
    struct Value {
        std::string text;              ///< as given, else the default
        std::vector<std::string> list; ///< of an option with several values
        bool flag = false;
    };
    std::map<std::string, Value, std::less<>> values;
    mutable std::string as_file; ///< the file equivalent to a scene given by words

    /// Empty for an option that the command does not have.
    [[nodiscard]] const Value& value(std::string_view name) const;
    [[nodiscard]] const std::string& operator[](std::string_view name) const {
        return value(name).text;
    }
    void set(const std::string& name, std::string text) { values[name].text = std::move(text); }
    [[nodiscard]] const std::vector<std::string>& list(std::string_view name) const {
        return value(name).list;
    }
    [[nodiscard]] bool has(std::string_view flag) const { return value(flag).flag; }
};

/// A subcommand, and the function that runs it. It returns the exit status: 0 good, 1 differs or
/// fails the target, 2 bad input. An interruption (130, 143) is thrown (below).
struct Command {
    const char* name;
    int (*run)(Options&); ///< null: this program only has the name
};

int pressure(Options& options);
int expand(Options& options);
int extent(Options& options);
int slip(Options& options);
int stress(Options& options);
int displacement(Options& options);
int plot(Options& options);
int relations(Options& options);
int design(Options& options);
int table(Options& options);
int points(Options& options);
int check(Options& options);
int compare(Options& options);
int verify(Options& options);

/// The commands for one scene.
inline constexpr Command scene_commands[] = {{"pressure", pressure}, {"expand", expand},
                                             {"extent", extent},     {"slip", slip},
                                             {"stress", stress},     {"displacement", displacement},
                                             {"plot", plot}};

/// Runs the program with all its commands and returns its exit status. `cost`: the command of the
/// module above this one.
[[nodiscard]] int run_edgeproof(int argc, char** argv, int (*cost)(Options&));

/// The program with these subcommands: reads the command line, runs the command that it names, and
/// prints the error, if there is one. Returns the exit status.
[[nodiscard]] int run_program(int argc, char** argv, const std::vector<Command>& commands);

/// share/edgeproof/commands.txt when the program was built: the commands, their options and help.
extern const std::string_view commands_txt;
/// Adds a subcommand with its options as commands_txt has them. If it is chosen, its exit status is
/// written to `code`.
void add_command(CLI::App& app, int& code, const Command& command);

/// Returns the keys of a scene, a recipe or a ledger, by its JSON schema.
[[nodiscard]] std::string help_of_keys(const std::string& kind);

/// Shows the number of items done, the rate and the time left on stderr, if that is a terminal that
/// obeys escape sequences and the work takes more than half a second. The line is wiped at the end.
class Progress {
public:
    explicit Progress(std::string what);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    /// May be called from any thread.
    void operator()(std::size_t done, std::size_t total);

private:
    std::string what_;
    bool terminal_;
    std::mutex showing_;
    std::chrono::steady_clock::time_point begun_;
    std::chrono::steady_clock::time_point last_;
    std::size_t first_ = 0; ///< the number done at the first call
    bool called_ = false;
};
/// Wipes the line of a Progress, if it is on the screen.
void wipe_progress();

/// Returns work(), during which calls of `shown` show the progress as `what`.
template <class Work>
decltype(auto) with_progress(std::string what, std::function<void(std::size_t, std::size_t)>& shown,
                             const Work& work) {
    Progress progress(std::move(what));
    shown = std::ref(progress);
    return work();
}

/// The width of the terminal on stdout in columns; 100 if it is not a terminal.
[[nodiscard]] std::size_t terminal_width();
/// The greatest width of a table on stdout in columns; 0, unlimited, if it is not a terminal.
[[nodiscard]] std::size_t width_to_wrap_at();
/// True if stdout is a terminal that obeys escape sequences (TERM is set and not "dumb") and
/// NO_COLOR (no-color.org) does not refuse colours.
[[nodiscard]] bool stdout_takes_colour();

/// Writes manual pages into a folder: man1/edgeproof.1 with the help, man1/edgeproof-NAME.1 with
/// that of each subcommand.
void write_manual(const CLI::App& app, const std::string& version,
                  const std::filesystem::path& folder);

/// Returns the proposals for the last of these words, the arguments typed so far.
[[nodiscard]] std::vector<std::string> completions(const CLI::App& app,
                                                   const std::vector<std::string>& words);

/// Copies the standard error of programs that are run to ours as it arrives, up to most_bytes in
/// all; then one line states that the rest is left out.
class ProgramMessages {
public:
    static constexpr std::size_t most_bytes = 65'536;
    void operator()(std::string_view text);

private:
    std::size_t shown_ = 0;
    bool cut_ = false;
};

// Files that come with the program, found by their place relative to it (installed.cpp).

/// Returns the path of a file given by its path relative to the program's folder.
[[nodiscard]] std::filesystem::path installed(const std::filesystem::path& file);

/// Returns the path of a folder of the files that came with the program.
[[nodiscard]] std::filesystem::path shipped(std::string_view folder);

inline constexpr std::string_view shipped_ledgers = "verify";
inline constexpr std::string_view shipped_recipes = "reference";
inline constexpr std::string_view shipped_scenes = "examples/scenes";
inline constexpr std::string_view shipped_designs = "examples/design";

/// Returns the file for a command. A bare name ("moore-hills") that is not a file in the current
/// folder means a file in that folder of the program's files, if there is one; anything else is
/// returned unchanged.
[[nodiscard]] std::string file_or_shipped(const std::string& given, std::string_view folder);

/// Returns the names of the files in that folder that file_or_shipped finds, in order.
[[nodiscard]] std::vector<std::string> shipped_names(std::string_view folder);

// The end of the program (signals.cpp).

/// Replaces standard streams that the caller has closed, so that no file opened later takes their
/// place: reads and writes on such a stream fail. Must be called first.
void open_standard_streams();

/// After this call SIGINT, SIGTERM and SIGHUP (unless it is ignored, as by nohup) end the program
/// in at most two seconds. They request an interruption, which the work notices at its next check
/// (precision/interruption.hpp). If there is no check within a second, or at a second signal, the
/// process ends at once. In both cases child processes are ended, temporary files are removed, and
/// the exit status is 128 plus the signal's number. Must be called before any thread is started:
/// the signals are blocked in all threads, and one thread waits for them.
void take_signals();

/// After this call an abort in a library (GMP without memory, MPFR, FLINT) or an uncaught exception
/// ends the program with one line and exit status 2.
void take_aborts();

/// Writes the line with the reason for the program's end to standard error. Does not return if a
/// second signal has already written its own line and ends the process.
void say_at_the_end(const std::string& line);

/// Returns the exit status of an interrupted program: 130 for SIGINT, 143 for SIGTERM.
[[nodiscard]] int interrupted_status();

} // namespace edgeproof::cli
