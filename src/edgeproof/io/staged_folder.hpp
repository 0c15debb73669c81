// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/io/process_cleanup.hpp"
#include "edgeproof/precision/error.hpp"

#include <filesystem>
#include <functional>
#include <string>

namespace edgeproof::io {

/// Files of one result that come to be together: they are written into a folder of their own, which
/// commit() makes the one asked for, or whose files it moves into that one where it is there
/// already. Without commit(), also where a signal ends the process, everything is as it was. What
/// runs that were killed left behind is removed first.
///
/// Where the folder is there already, SIGKILL or a loss of power between two of the moves, some
/// microseconds long, is the one way to find files of two runs in it; each is whole even then.
class StagedFolder {
public:
    /// Throws InputError where `target` cannot be made, or not be written into.
    explicit StagedFolder(const std::filesystem::path& target);
    ~StagedFolder();
    StagedFolder(const StagedFolder&) = delete;
    StagedFolder& operator=(const StagedFolder&) = delete;

    /// To write into.
    [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }
    /// Calls `write` with that path. Errors name the folder that was asked for.
    void fill(const std::function<void(const std::filesystem::path&)>& write) const;
    /// What a user is told of a file that cannot be written there: the name that it was to have.
    [[nodiscard]] InputError told(const InputError& error) const;
    /// Throws InputError; Interrupted, and then nothing is moved.
    void commit();

private:
    std::filesystem::path target_;
    bool inside_;               ///< the target was there
    std::filesystem::path top_; ///< the highest folder that commit() makes; else the target
    TemporaryPath stage_;       ///< which becomes top_
    std::filesystem::path path_;
    int lock_; ///< on the stage: tells other runs that it is in use
};

} // namespace edgeproof::io
