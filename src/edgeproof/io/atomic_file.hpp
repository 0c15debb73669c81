// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/io/process_cleanup.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace edgeproof::io {

/// Writes all of the text to an open file: 0, or the error.
[[nodiscard]] int write_all(int fd, const std::string& text);

/// What to do about a file that cannot be written.
inline constexpr const char* give_writable_folder =
    "give a folder that can be written to, with free space";

/// Removes what processes that are no more left beside a file, or a folder, under names of the kind
/// "t.csv.4711.tmp". What a process that lives writes there is locked (flock).
void remove_left_over(const std::filesystem::path& file);

/// Where a file that is to be written leads: links followed, a device or FIFO told from a file.
struct OutputTarget {
    std::filesystem::path path;   ///< no link
    int descriptor = -1;          ///< of this process, for /dev/stdout, /dev/fd/N, /proc/self/fd/N
    bool special = false;         ///< no regular file: written as it is, and never replaced
    std::optional<unsigned> mode; ///< permissions of the file that is there
    /// Throws InputError for a folder and for a link that leads nowhere in forty steps.
    [[nodiscard]] static OutputTarget of(const std::filesystem::path& file);
};

/// A file written in parts, in a folder that is made where there is none, and seen by others only
/// when it is whole: until then it has no name, or, where the file system knows no such files, one
/// by the process ("t.csv.4711.tmp"). Throws InputError where it cannot be written, Interrupted
/// where that was asked for; what was written is removed then, and where it is not committed. What
/// runs that were killed left beside it under such names is removed first. A link stays, and the
/// file that it leads to is written; a file that is there keeps its permissions; a device, a FIFO
/// or an open descriptor is written to as it is.
class AtomicFile {
public:
    /// What a checkpoint holds is right in an interrupted process as well; a result is not written
    /// there, as it may be of work that was cut off.
    enum class Content { result, checkpoint };

    explicit AtomicFile(std::filesystem::path file, Content content = Content::result);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    void write(const std::string& text);
    void commit();

private:
    void flush();
    void give_name();
    [[noreturn]] void cannot(int error);

    std::filesystem::path file_; ///< as it was named
    OutputTarget target_;
    TemporaryPath aside_; ///< its name before it is whole
    Content content_;
    std::string waiting_;
    int fd_ = -1;
    bool named_ = false;
};

} // namespace edgeproof::io
