// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace edgeproof::io {

/// Another program, and how far it may go.
struct ProgramCall {
    /// The program, by its path, and its arguments.
    std::vector<std::string> arguments;
    /// NAME=VALUE of each variable that it sees; nothing: ours.
    std::optional<std::vector<std::string>> environment = {};
    std::string input = {};                ///< on its standard input
    double seconds = 600;                  ///< that it may take
    std::size_t most_output = 200'000'000; ///< bytes on its standard output
    /// Is given its standard error, as it comes; without it that is read and dropped.
    std::function<void(std::string_view)> said = {};
};

/// A call of /bin/sh with that command.
[[nodiscard]] ProgramCall shell_call(const std::string& command);

/// How a program ended, and what it wrote until then.
struct ProgramRun {
    std::string output;
    int exit_code = 0;
    int signal = 0; ///< that ended it; 0: none
    bool timed_out = false;
    bool too_much = false;        ///< more output than most_output, which is all that is kept
    double processor_seconds = 0; ///< of the program, and of what it started and waited for

    /// "ended with exit code 3", "was ended by signal 11 (...)"; empty where it ended well.
    [[nodiscard]] std::string ending() const;
};

/// Runs a program until it ends, or until the seconds are over, the output is too much: then it
/// is killed. What it started and left behind is killed in either case, and is not waited for. The
/// only place where processes are started. Throws Error where it cannot be started; Interrupted.
[[nodiscard]] ProgramRun run_program(const ProgramCall& call);

} // namespace edgeproof::io
