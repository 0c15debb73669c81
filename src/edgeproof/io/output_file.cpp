// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/io/output_file.hpp"
#include "edgeproof/io/atomic_file.hpp"
#include "edgeproof/io/own_file.hpp"
#include "edgeproof/io/text_file.hpp"
#include "edgeproof/precision/error.hpp"

#include <unistd.h>

#include <algorithm>
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

namespace {

constexpr std::size_t hash_digits = 16;

bool is_file_name_character(char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-' ||
           c == '_' || c == '.';
}

bool begins_well(std::string_view name) {
    return !name.empty() && name.front() != '.' && name.front() != '-';
}

/// True for a text that ends like "-0123456789abcdef", the form of a changed name. Such an id is
/// changed, too, so that no id equals the name of another one.
bool ends_as_changed(std::string_view id) {
    if (id.size() <= hash_digits || id[id.size() - hash_digits - 1] != '-') {
        return false;
    }
    const std::string_view end = id.substr(id.size() - hash_digits);
    return end.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

} // namespace

FileStem::FileStem(std::string_view id) : text_(id) {
    if (id.size() <= most_bytes && begins_well(id) && !ends_as_changed(id) &&
        std::ranges::all_of(id, is_file_name_character)) {
        return;
    }
    text_.resize(std::min(text_.size(), most_bytes - hash_digits - 1));
    std::ranges::replace_if(
        text_, [](char c) { return !is_file_name_character(c); }, '-');
    if (!text_.empty() && !begins_well(text_)) {
        text_.front() = '_';
    }
    text_ = (text_.empty() ? "_" : text_) + '-' + sha256(id).substr(0, hash_digits);
}

} // namespace edgeproof::io
