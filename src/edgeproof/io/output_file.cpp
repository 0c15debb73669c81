// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/io/output_file.hpp"
#include "edgeproof/io/atomic_file.hpp"
#include "edgeproof/io/own_file.hpp"
#include "edgeproof/precision/error.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

namespace edgeproof::io {
namespace {

/// `errno` is 0 or the error of the last output: a stream does not store the number of an earlier
/// error.
void flush_printed() {
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
        throw InputError("cannot write standard output" +
                             (errno != 0 ? std::string(": ") + std::strerror(errno) : ""),
                         errno == EPIPE
                             ? "the program that reads it ended before the end of the output"
                             : "make room where it is sent");
    }
}

} // namespace

void write_whole(const std::filesystem::path& file, const std::string& text) {
    AtomicFile(file).commit(text);
}

void write_output(const std::filesystem::path& file, const std::string& text) {
    if (file != "-") {
        write_whole(file, text);
        return;
    }
    errno = 0;
    (void)std::fwrite(text.data(), 1, text.size(), stdout);
    flush_printed();
}

void finish_standard_output() {
    errno = 0;
    flush_printed();
}

void check_output(const std::filesystem::path& file) {
    if (file.empty() || file == "-") {
        return;
    }
    const OutputTarget target = OutputTarget::of(file);
    if (!target.special) {
        const auto folder = target.path.parent_path();
        check_folder(folder.empty() ? std::filesystem::path(".") : folder);
        require_replaceable(file);
    } else if (target.descriptor < 0 && ::access(target.path.c_str(), W_OK) != 0) {
        cannot("write", file, errno);
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

void check_folder(const std::filesystem::path& folder) {
    std::filesystem::path there = folder; // the nearest existing folder
    std::error_code none;
    while (!there.empty() && !std::filesystem::exists(there, none)) {
        there = there.parent_path();
    }
    if (there.empty()) {
        there = ".";
    }
    if (!std::filesystem::is_directory(there, none)) {
        cannot("make the folder", folder, ENOTDIR);
    }
    if (::access(there.c_str(), W_OK | X_OK) != 0) {
        cannot(there == folder ? "write into" : "make the folder", folder, errno);
    }
}

bool is_file_stem(std::string_view name) {
    constexpr std::size_t most_bytes = 120;
    constexpr std::string_view known =
        "0123456789abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ-_.";
    return !name.empty() && name.size() <= most_bytes && name.front() != '.' &&
           name.front() != '-' && name.find_first_not_of(known) == std::string_view::npos;
}

} // namespace edgeproof::io
