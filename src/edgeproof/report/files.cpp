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

} // namespace

void write_whole(const std::filesystem::path& file, const std::string& text) {
    // The process's own name, so that two runs into one folder do not share it.
    const std::filesystem::path aside = file.string() + "." + std::to_string(::getpid()) + ".tmp";
    const int fd = ::open(aside.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (fd < 0) {
        cannot("write", file, errno);
    }
    int error = 0;
    std::size_t at = 0;
    while (at < text.size() && error == 0) {
        const ssize_t n = ::write(fd, text.data() + at, text.size() - at);
        if (n < 0 && errno != EINTR) {
            error = errno;
        } else if (n > 0) {
            at += static_cast<std::size_t>(n);
        }
    }
    if (error == 0 && ::fsync(fd) != 0) {
        error = errno;
    }
    if (::close(fd) != 0 && error == 0) {
        error = errno;
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
