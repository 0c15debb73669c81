// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <sys/types.h>

#include <cstddef>
#include <filesystem>
#include <functional>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

namespace edgeproof::io {

// Things that must not outlive this process: temporary files and folders, and child programs. All
// are registered here, so that a process that cannot wait for its threads (cli/signals.cpp) still
// leaves nothing behind. Only SIGKILL and a loss of power do.

/// Delays clean_up() during its lifetime, so that creating or finally naming a registered thing is
/// one step. Waits for ever once clean_up() has begun, since the process is about to end.
[[nodiscard]] std::unique_lock<std::timed_mutex> hold_cleanup();

/// A file or a folder with its contents; clean_up() removes it during the lifetime of this object.
class TemporaryPath {
public:
    explicit TemporaryPath(std::filesystem::path path);
    /// Registers the path that `make` creates.
    explicit TemporaryPath(const std::function<std::filesystem::path()>& make);
    ~TemporaryPath();
    TemporaryPath(const TemporaryPath&) = delete;
    TemporaryPath& operator=(const TemporaryPath&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }
    /// Makes the path permanent. For a caller that holds hold_cleanup().
    void keep_locked() noexcept;

private:
    std::filesystem::path path_;
    bool registered_ = true;
};

/// From now on, a process whose parent has ended becomes a child of this one, where it is found and
/// ended also if it has left its session and cleared its environment. For a program whose children
/// are all started by ChildGroup.
void adopt_orphans();

/// Returns a variable (NAME=VALUE) that no child has been given before. All descendants of a child
/// inherit it, including those that left the process group (setsid).
[[nodiscard]] std::string new_mark();

/// A child program that leads its own process group; `start` starts it and returns its process id.
/// The group, and all processes with `mark` in their environment, are killed by end() and wait(),
/// by clean_up(), and by the destructor.
class ChildGroup {
public:
    explicit ChildGroup(const std::function<pid_t()>& start, std::string mark = {});
    ~ChildGroup();
    ChildGroup(const ChildGroup&) = delete;
    ChildGroup& operator=(const ChildGroup&) = delete;

    /// Sends SIGKILL to all of them.
    void end() const;
    /// True if the child has ended; wait() is still needed.
    [[nodiscard]] bool ended() const;
    /// Waits for the child, kills processes that it left, and returns its status (as waitpid does).
    int wait();

private:
    pid_t pid_;
    std::string mark_;
};

/// Kills the children and removes the temporary paths. For one call right before the process ends:
/// later registrations block until then.
void clean_up() noexcept;

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
