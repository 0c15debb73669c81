// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
/// The program's subcommands, one file each. Every add_... function adds its command to the command
/// line; the command that is run writes its exit status to `code`: 0 good, 1 differs or fails the
/// target, 2 bad input. An interruption (130, 143) is thrown (signals.hpp).
#include <CLI/CLI.hpp>

#include <chrono>
#include <cstddef>
#include <mutex>
#include <string>
#include <string_view>

namespace edgeproof::cli {

void add_verify(CLI::App& app, int& code);
void add_pressure(CLI::App& app, int& code);
void add_expand(CLI::App& app, int& code);
void add_extent(CLI::App& app, int& code);
void add_slip(CLI::App& app, int& code);
void add_plot(CLI::App& app, int& code);
void add_slip_table(CLI::App& app, int& code);
void add_explain(CLI::App& app, int& code);
void add_relations(CLI::App& app, int& code);
void add_design(CLI::App& app, int& code);
void add_table(CLI::App& app, int& code);
void add_points(CLI::App& app, int& code);
void add_check(CLI::App& app, int& code);
void add_compare(CLI::App& app, int& code);
void add_pack(CLI::App& app, int& code);
void add_certify(CLI::App& app, int& code);

/// Shows the number of items done, the rate and the time left on stderr, if that is a terminal that
/// obeys escape sequences. The line is wiped at the end.
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
    std::size_t shown_ = 0;
};

/// The width of the terminal on stdout in columns; 100 if it is not a terminal.
[[nodiscard]] std::size_t terminal_width();
/// The greatest width of a table on stdout in columns; 0, unlimited, if it is not a terminal.
[[nodiscard]] std::size_t width_to_wrap_at();
/// True if stdout is a terminal that obeys escape sequences (TERM is set and not "dumb") and
/// NO_COLOR (no-color.org) does not refuse colours.
[[nodiscard]] bool stdout_takes_colour();

/// Returns the error in a command line that CLI11 refused because of an unknown subcommand or
/// option: "unknown option '--digit'; did you mean --digits? write one of ...". Empty if all are
/// known.
[[nodiscard]] std::string unknown_on_command_line(const CLI::App& app, int argc,
                                                  const char* const* argv);

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

} // namespace edgeproof::cli
