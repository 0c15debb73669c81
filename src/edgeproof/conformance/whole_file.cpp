// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/conformance/whole_file.hpp"

#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstring>
#include <system_error>
#include <utility>

namespace edgeproof {
namespace {

constexpr std::size_t write_at_once = 1 << 20;
const std::string after = ".tmp";

std::filesystem::path folder_of(const std::filesystem::path& file) {
    return file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
}

/// A file without a name, where the system has such files and a way to name them later; else -1.
int open_unnamed(const std::filesystem::path& folder) {
#ifdef O_TMPFILE
    if (::access("/proc/self/fd", X_OK) == 0) {
        return ::open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0666);
    }
#endif
    return -1;
}

} // namespace

void remove_left_over(const std::filesystem::path& file) {
    const std::string before = file.filename().string() + ".";
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator(folder_of(file), ignored)) {
        const std::string name = entry.path().filename().string();
        if (name.size() <= before.size() + after.size() || !name.starts_with(before) ||
            !name.ends_with(after)) {
            continue;
        }
        pid_t process = 0;
        const char* const end = name.data() + name.size() - after.size();
        const auto [stop, error] = std::from_chars(name.data() + before.size(), end, process);
        const bool ours = error == std::errc{} && stop == end && process > 0;
        if (ours && ::kill(process, 0) != 0 && errno == ESRCH) {
            std::filesystem::remove_all(entry.path(), ignored);
        }
    }
}

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

WholeFile::WholeFile(std::filesystem::path file, Content content)
    : file_(std::move(file)),
      aside_(std::filesystem::path(file_.string() + "." + std::to_string(::getpid()) + after)),
      content_(content) {
    remove_left_over(file_);
    fd_ = open_unnamed(folder_of(file_));
    if (fd_ < 0) {
        named_ = true;
        fd_ = ::open(aside_.path().c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    }
    if (fd_ < 0) {
        cannot(errno);
    }
}

WholeFile::~WholeFile() {
    if (fd_ >= 0) {
        ::close(fd_);
        if (named_) {
            ::unlink(aside_.path().c_str());
        }
    }
}

void WholeFile::cannot(int error) {
    throw InputError("cannot write " + file_.string() + ": " + std::strerror(error), make_room);
}

void WholeFile::write(const std::string& text) {
    waiting_ += text;
    if (waiting_.size() >= write_at_once) {
        flush();
    }
}

void WholeFile::flush() {
    if (const int error = write_all(fd_, waiting_); error != 0) {
        cannot(error);
    }
    waiting_.clear();
}

void WholeFile::give_name() {
    const std::string by_number = "/proc/self/fd/" + std::to_string(fd_);
    ::unlink(aside_.path().c_str());
    if (::linkat(AT_FDCWD, by_number.c_str(), AT_FDCWD, aside_.path().c_str(), AT_SYMLINK_FOLLOW) !=
        0) {
        cannot(errno);
    }
    named_ = true;
}

void WholeFile::commit() {
    flush();
    if (content_ == Content::result) {
        check_interruption();
    }
    if (::fsync(fd_) != 0) {
        cannot(errno);
    }
    const auto lock = hold_cleanup();
    if (!named_) {
        give_name();
    }
    if (::rename(aside_.path().c_str(), file_.c_str()) != 0) {
        cannot(errno);
    }
    aside_.keep_locked();
    ::close(fd_);
    fd_ = -1;
}

} // namespace edgeproof
