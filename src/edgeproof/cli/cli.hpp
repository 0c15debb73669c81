// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
/// The program's subcommands, a file each. Every one adds itself to the command line and, when it
/// is the one asked for, leaves its exit code in `code`: 0 good, 1 differs or fails the target, 2
/// bad input. An interruption (130, 143) is thrown (signals.hpp).
#include <CLI/CLI.hpp>

#include <chrono>
#include <cstddef>
#include <mutex>
#include <string>

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
void add_mutate(CLI::App& app, int& code);
void add_certify(CLI::App& app, int& code);
void add_bounds(CLI::App& app, int& code);
void add_cost(CLI::App& app, int& code);

/// A count of work done, with its rate and what is left, on stderr, only where that is a terminal
/// that obeys escapes;
/// wiped when it ends.
class Progress {
public:
    explicit Progress(std::string what);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    /// From any thread.
    void operator()(std::size_t done, std::size_t total);

private:
    std::string what_;
    bool terminal_;
    std::mutex showing_;
    std::chrono::steady_clock::time_point begun_;
    std::chrono::steady_clock::time_point last_;
    std::size_t first_ = 0; ///< done already when it was first told
    std::size_t shown_ = 0;
};

/// Columns of the terminal on stdout, 100 where it is none.
[[nodiscard]] std::size_t terminal_width();
/// Columns that a table on stdout has: 0, as many as it takes, where that is no terminal.
[[nodiscard]] std::size_t width_to_wrap_at();
/// A terminal that obeys escapes (TERM is set and not "dumb"), and colours are not refused by
/// NO_COLOR (no-color.org).
[[nodiscard]] bool stdout_takes_colour();

/// What is wrong with a command line that CLI11 refused, where a subcommand or an option is not
/// known: "unknown option '--digit'; did you mean --digits? write one of ...". Empty where all are.
[[nodiscard]] std::string unknown_on_command_line(const CLI::App& app, int argc,
                                                  const char* const* argv);

} // namespace edgeproof::cli
