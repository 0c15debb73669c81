// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <mutex>
#include <string>

namespace edgeproof::io {

// What must not outlive this process, however it ends: files and folders that are not results, and
// child programs. All of it is registered here, so that a process that cannot wait for its threads
// (cli/signals.hpp) still leaves nothing behind. Only SIGKILL and a loss of power do.

/// Holds back clean_up() while it lives: a registered thing comes to be, or gets its final name, in
/// one step. Waits for ever once clean_up() has begun, as the process is about to end.
[[nodiscard]] std::unique_lock<std::timed_mutex> hold_cleanup();

/// A file, or a folder with all that is in it, removed by clean_up() while this lives.
class TemporaryPath {
public:
    explicit TemporaryPath(std::filesystem::path path);
    /// Of one that `make` makes.
    explicit TemporaryPath(const std::function<std::filesystem::path()>& make);
    ~TemporaryPath();
    TemporaryPath(const TemporaryPath&) = delete;
    TemporaryPath& operator=(const TemporaryPath&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }
    /// No longer temporary. For a caller that holds hold_cleanup().
    void keep_locked() noexcept;

private:
    std::filesystem::path path_;
    bool registered_ = true;
};

/// A variable (NAME=VALUE) that no child has been given before. All that descends from a child has
/// it in its environment, also what has left the process group (setsid).
[[nodiscard]] std::string new_mark();

/// A child program that leads a process group of its own, as `start` makes it (its process id). The
/// group, and all processes that have `mark` in their environment, are ended by end() and wait(),
/// by clean_up(), and when this is gone.
class ChildGroup {
public:
    explicit ChildGroup(const std::function<pid_t()>& start, std::string mark = {});
    ~ChildGroup();
    ChildGroup(const ChildGroup&) = delete;
    ChildGroup& operator=(const ChildGroup&) = delete;

    /// SIGKILL to all of them.
    void end() const;
    /// Whether the child has ended; it is still to be waited for.
    [[nodiscard]] bool ended() const;
    /// Waits for the child, ends what it left behind, and gives its status (as waitpid does).
    /// `processor_seconds`: set to what it took.
    int wait(double* processor_seconds = nullptr);

private:
    pid_t pid_;
    std::string mark_;
};

/// What a user is told of work that is kept, where the process ends in the middle; empty: nothing.
/// Replaces the text set before, until it is gone.
class KeptNote {
public:
    explicit KeptNote(std::string text);
    ~KeptNote();
    KeptNote(const KeptNote&) = delete;
    KeptNote& operator=(const KeptNote&) = delete;
};

/// Ends the children and removes the temporary paths. To be called once, right before the process
/// ends: whoever registers something afterwards waits for that. Returns the KeptNote's text.
std::string clean_up() noexcept;

} // namespace edgeproof::io
