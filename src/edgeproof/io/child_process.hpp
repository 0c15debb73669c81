// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace edgeproof::io {

/// A call of another program, and its limits.
struct ProgramCall {
    std::vector<std::string> arguments;
    std::string input = {};                ///< text on its standard input
    double seconds = 600;                  ///< the longest time allowed
    std::size_t most_output = 200'000'000; ///< the most bytes on its standard output
    /// Called with its standard error as it arrives; without it, standard error is read and
    /// dropped.
    std::function<void(std::string_view)> said = {};
};

/// Returns a call of /bin/sh with that command.
[[nodiscard]] ProgramCall shell_call(const std::string& command);

struct ProgramRun {
    std::string output;
    int exit_code = 0;
    int signal = 0; ///< the signal that ended it; 0: none
    bool timed_out = false;
    bool too_much = false; ///< more output than most_output; the rest is dropped

    /// Returns "ended with exit code 3", "was ended by signal 11 (...)"; empty after success.
    [[nodiscard]] std::string ending() const;
};

/// Runs a program until it ends; kills it if it exceeds the time or the output allowed. Processes
/// that it leaves running are killed in either case, without waiting for them. Only this function
/// starts processes. Throws Error if the program cannot be started; Interrupted.
[[nodiscard]] ProgramRun run_program(const ProgramCall& call);

} // namespace edgeproof::io
