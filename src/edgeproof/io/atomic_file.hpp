// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/io/process_cleanup.hpp"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

namespace edgeproof::io {

inline constexpr const char* give_writable_folder =
    "give a folder that can be written to, with free space";

/// Throws InputError: "cannot WHAT PATH: the text of the error number".
[[noreturn]] void cannot(const std::string& what, const std::filesystem::path& path, int error);

/// Returns a name next to a file or folder that no other process uses
/// ("t.csv.0123456789abcdef.tmp").
[[nodiscard]] std::filesystem::path temporary_name(const std::filesystem::path& target);

/// The files that did not exist before an AtomicFile of this process wrote them.
[[nodiscard]] std::size_t files_created();

/// The target of a file to be written: links are followed, devices and FIFOs are detected.
struct OutputTarget {
    std::filesystem::path path;   ///< not a link
    int descriptor = -1;          ///< of this process, for /dev/stdout, /dev/fd/N, /proc/self/fd/N
    bool special = false;         ///< not a regular file: written directly, and never replaced
    std::optional<unsigned> mode; ///< permissions of an existing file
    /// Throws InputError for a folder and for a chain of more than forty links.
    [[nodiscard]] static OutputTarget of(const std::filesystem::path& file);
};

/// A file whose name appears only when it is complete. A missing folder is created. Throws
/// InputError if the file cannot be written or replaced (require_replaceable), Interrupted after an
/// interruption; no text remains then, as without commit(). A link is kept, and its target is
/// written; an existing file keeps its permissions; a device, a FIFO or an open descriptor is
/// written directly.
class AtomicFile {
public:
    explicit AtomicFile(std::filesystem::path file);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    /// Writes the whole text, and gives the file its name.
    void commit(const std::string& text);

private:
    std::filesystem::path file_; ///< as the user named it
    OutputTarget target_;
    TemporaryPath aside_; ///< its temporary name
    int fd_ = -1;
};

} // namespace edgeproof::io
