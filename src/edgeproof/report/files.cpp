// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/report/files.hpp"

#include "edgeproof/precision/error.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace edgeproof {
namespace {

[[noreturn]] void cannot(const std::string& what, const std::filesystem::path& path, int error) {
    throw InputError("cannot " + what + " " + path.string() + ": " + std::strerror(error),
                     "give a folder that can be written to, with room in it");
}

/// 0, or the error.
int write_all(int fd, const std::string& text) {
    std::size_t at = 0;
    while (at < text.size()) {
        const ssize_t n = ::write(fd, text.data() + at, text.size() - at);
        if (n < 0 && errno != EINTR) {
            return errno;
        }
        at += n > 0 ? static_cast<std::size_t>(n) : 0;
    }
    return ::fsync(fd) != 0 ? errno : 0;
}

/// Writes to the file `aside`, unnamed until all is written, so that a run that is killed leaves
/// nothing of it: EOPNOTSUPP where the system has no such files. 0, or the error.
int write_aside(const std::filesystem::path& file, const std::filesystem::path& aside,
                const std::string& text, bool unnamed) {
#ifdef O_TMPFILE
    const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
    const int fd = unnamed ? ::open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0666)
                           : ::open(aside.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
#else
    const int fd = unnamed ? (errno = EOPNOTSUPP, -1)
                           : ::open(aside.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
#endif
    if (fd < 0) {
        // EISDIR is what a kernel says that knows no such files.
        return unnamed && errno == EISDIR ? EOPNOTSUPP : errno;
    }
    int error = write_all(fd, text);
    if (error == 0 && unnamed) {
        ::unlink(aside.c_str());
        const std::string by_number = "/proc/self/fd/" + std::to_string(fd);
        if (::linkat(AT_FDCWD, by_number.c_str(), AT_FDCWD, aside.c_str(), AT_SYMLINK_FOLLOW) !=
            0) {
            error = ::access("/proc/self/fd", X_OK) == 0 ? errno : EOPNOTSUPP;
        }
    }
    if (::close(fd) != 0 && error == 0) {
        error = errno;
    }
    return error;
}

} // namespace

void write_whole(const std::filesystem::path& file, const std::string& text) {
    // The process's own name, so that two runs into one folder do not share it.
    const std::filesystem::path aside = file.string() + "." + std::to_string(::getpid()) + ".tmp";
    int error = write_aside(file, aside, text, true);
    if (error == EOPNOTSUPP) {
        error = write_aside(file, aside, text, false);
    }
    if (error == 0 && ::rename(aside.c_str(), file.c_str()) != 0) {
        error = errno;
    }
    if (error != 0) {
        ::unlink(aside.c_str());
        cannot("write", file, error);
    }
}

void make_folder(const std::filesystem::path& folder) {
    std::error_code failed;
    std::filesystem::create_directories(folder, failed);
    if (failed) {
        cannot("make the folder", folder, failed.value());
    }
    if (::access(folder.c_str(), W_OK | X_OK) != 0) {
        cannot("write into", folder, errno);
    }
}

} // namespace edgeproof
