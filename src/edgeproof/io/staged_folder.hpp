// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/io/process_cleanup.hpp"
#include "edgeproof/precision/error.hpp"

#include <filesystem>
#include <functional>
#include <string>

namespace edgeproof::io {

/// The files of one result, which appear together. They are written into a temporary folder.
/// commit() renames it to the target folder, or moves its files into that folder if it exists
/// already. Without commit(), also after a signal, nothing changes. Leftovers of killed runs are
/// removed first.
///
/// If the target exists, only SIGKILL or a loss of power between two moves (some microseconds) can
/// leave files of two runs in it; even then each file is complete.
class StagedFolder {
public:
    /// Throws InputError if `target` cannot be created or is not writable.
    explicit StagedFolder(const std::filesystem::path& target);
    ~StagedFolder();
    StagedFolder(const StagedFolder&) = delete;
    StagedFolder& operator=(const StagedFolder&) = delete;

    /// The folder to write into.
    [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }
    /// Calls `write` with that path. Errors name the target folder.
    void fill(const std::function<void(const std::filesystem::path&)>& write) const;
    /// Returns the error for the user if a file cannot be written there: with the final name of the
    /// file.
    [[nodiscard]] InputError with_final_names(const InputError& error) const;
    /// Throws InputError; or Interrupted, and then nothing is moved.
    void commit();

private:
    std::filesystem::path target_;
    bool inside_;               ///< the target exists
    std::filesystem::path top_; ///< the highest folder that commit() creates; else the target
    TemporaryPath stage_;       ///< becomes top_
    std::filesystem::path path_;
    int lock_; ///< a lock on the stage: shows other runs that it is in use
};

} // namespace edgeproof::io
