// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/io/atomic_file.hpp"

#include "edgeproof/io/own_file.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"

#include <fmt/format.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <random>
#include <string_view>
#include <system_error>
#include <utility>

namespace edgeproof::io {
namespace {

constexpr std::size_t most_of_head = 4096;

/// The files that commit() has created.
std::atomic<std::size_t> created{0};

std::filesystem::path folder_of(const std::filesystem::path& file) {
    return file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
}

/// Returns N for a name of this process's descriptor N, else -1.
int own_descriptor(const std::filesystem::path& file) {
    const std::string name = file.lexically_normal().string();
    if (name == "/dev/stdout") {
        return STDOUT_FILENO;
    }
    if (name == "/dev/stderr") {
        return STDERR_FILENO;
    }
    for (const std::string_view folder : {"/dev/fd/", "/proc/self/fd/"}) {
        int number = -1;
        const char* const end = name.data() + name.size();
        if (name.starts_with(folder)) {
            const auto [stop, error] = std::from_chars(name.data() + folder.size(), end, number);
            return error == std::errc{} && stop == end ? number : -1;
        }
    }
    return -1;
}

/// Writes the whole text to an open file. Returns 0, or the error number.
int write_all(int fd, const std::string& text) {
    std::size_t at = 0;
    while (at < text.size()) {
        const ssize_t n = ::write(fd, text.data() + at, text.size() - at);
        if (n < 0 && errno != EINTR) {
            return errno;
        }
        at += n > 0 ? static_cast<std::size_t>(n) : 0;
    }
    return 0;
}

} // namespace

void cannot(const std::string& what, const std::filesystem::path& path, int error) {
    throw InputError("cannot " + what + " " + path.string() + ": " + std::strerror(error),
                     give_writable_folder);
}

OutputTarget OutputTarget::of(const std::filesystem::path& file) {
    OutputTarget target;
    target.path = file;
    target.descriptor = own_descriptor(file);
    if (target.descriptor >= 0) {
        const int flags = ::fcntl(target.descriptor, F_GETFL);
        if (flags < 0 || (flags & O_ACCMODE) == O_RDONLY) {
            cannot("write", file, EBADF);
        }
        target.special = true;
        return target;
    }
    constexpr int most_links = 40; // as in the Linux kernel
    std::error_code none;
    for (int links = 0; std::filesystem::is_symlink(target.path, none); ++links) {
        const std::filesystem::path next = std::filesystem::read_symlink(target.path, none);
        if (links == most_links || next.empty()) {
            cannot("write", file, ELOOP);
        }
        target.path = next.is_absolute() ? next : folder_of(target.path) / next;
    }
    struct stat found {};
    if (::stat(target.path.c_str(), &found) == 0) {
        require(!S_ISDIR(found.st_mode), file.string() + " is a folder", "name a file");
        target.special = !S_ISREG(found.st_mode);
        target.mode = found.st_mode & 07777U;
    }
    return target;
}

std::filesystem::path temporary_name(const std::filesystem::path& target) {
    std::random_device random;
    return target.string() + fmt::format(".{:08x}{:08x}.tmp", random(), random());
}

std::size_t files_created() { return created; }

AtomicFile::AtomicFile(std::filesystem::path file)
    : file_(std::move(file)), target_(OutputTarget::of(file_)),
      aside_(temporary_name(target_.path)) {
    if (target_.special) {
        fd_ = target_.descriptor >= 0
                  ? ::fcntl(target_.descriptor, F_DUPFD_CLOEXEC, STDERR_FILENO + 1)
                  : ::open(target_.path.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY);
        if (fd_ < 0) {
            cannot("write", file_, errno);
        }
        return;
    }
    std::error_code reported_below;
    std::filesystem::create_directories(folder_of(target_.path), reported_below);
    fd_ = ::open(aside_.path().c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (fd_ < 0 || (target_.mode && ::fchmod(fd_, *target_.mode) != 0)) {
        cannot("write", file_, errno);
    }
}

AtomicFile::~AtomicFile() {
    if (fd_ >= 0) {
        ::close(fd_);
        ::unlink(aside_.path().c_str());
    }
}

void AtomicFile::commit(const std::string& text) {
    check_interruption(); // a result may be incomplete then
    if (const int error = write_all(fd_, text); error != 0) {
        cannot("write", file_, error);
    }
    if (target_.special) {
        ::close(fd_);
        fd_ = -1;
        return;
    }
    require_replaceable(file_, std::string_view(text).substr(0, most_of_head));
    if (::fsync(fd_) != 0) {
        cannot("write", file_, errno);
    }
    const auto lock = hold_cleanup();
    if (::rename(aside_.path().c_str(), target_.path.c_str()) != 0) {
        cannot("write", file_, errno);
    }
    aside_.keep_locked();
    created += target_.mode ? 0 : 1;
    ::close(fd_);
    fd_ = -1;
}

} // namespace edgeproof::io
