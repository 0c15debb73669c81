// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <atomic>
#include <string>

namespace edgeproof {

/// How a program ended, and what it wrote until then.
struct ProgramRun {
    std::string output;
    int exit_code = 0;
    int signal = 0; ///< that ended it; 0: none
    bool timed_out = false;
    bool too_much = false; ///< more output than anyone can have been asked for

    /// "ended with exit code 3", "was ended by signal 11 (...)"; empty where it ended well.
    [[nodiscard]] std::string ending() const;
};

/// Runs a command of the shell with `input` on its standard input until it ends, or until the
/// seconds are over or `stop` is set: then it is killed with all that it started. Its standard
/// error goes where ours goes. Throws Error where it cannot be started or was stopped.
[[nodiscard]] ProgramRun run_program(const std::string& command, const std::string& input,
                                     double seconds, const std::atomic<bool>* stop = nullptr);

} // namespace edgeproof
