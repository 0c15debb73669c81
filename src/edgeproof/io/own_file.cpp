// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/io/own_file.hpp"

#include "edgeproof/precision/error.hpp"

#include <sys/stat.h>

#include <algorithm>
#include <atomic>
#include <cctype>
#include <fstream>
#include <functional>
#include <mutex>
#include <set>
#include <string>
#include <utility>

namespace edgeproof::io {
namespace {

using Identity = std::pair<dev_t, ino_t>;

struct Inputs {
    std::atomic<bool> counted{false};
    std::mutex mutex;
    std::set<Identity> all;
};

Inputs& inputs() {
    static Inputs read;
    return read;
}

/// Returns the beginning without blanks, which depend on the width of columns.
std::string beginning_of(std::string_view text) {
    constexpr std::size_t enough = 16; // more than the first words of most files
    std::string out;
    for (const char c : text) {
        if (out.size() == enough) {
            break;
        }
        if (c != ' ' && c != '\n') {
            out += c;
        }
    }
    return out;
}

/// True for formats in which the files of all programs begin alike.
bool begins_like_any(std::string_view head) {
    return head.starts_with('<') || head.starts_with("\x89PNG") || head.starts_with("%PDF");
}

/// True for a line with "edgeproof 1.2.3 (".
bool names_program(std::string_view line) {
    constexpr std::string_view name = "edgeproof ";
    for (std::size_t at = line.find(name); at != std::string_view::npos; at = line.find(name, at)) {
        at += name.size();
        const std::size_t end = line.find_first_not_of("0123456789.", at);
        if (end > at && line.substr(end < line.size() ? end : line.size()).starts_with(" (")) {
            return true;
        }
    }
    return false;
}

bool contains_program(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    for (std::string line; std::getline(in, line);) {
        if (names_program(line)) {
            return true;
        }
    }
    return false;
}

char kind_of(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 ? 'a' : c; }

/// A text of the user's may quote a result, but it then begins in another way.
bool is_own(const std::filesystem::path& file, std::string_view head) {
    const std::string line = first_bytes(file);
    if (!begins_like_any(head) && beginning_of(line) == beginning_of(head)) {
        return true;
    }
    if (line.empty() || head.empty() || kind_of(line.front()) != kind_of(head.front())) {
        return false;
    }
    return contains_program(file);
}

/// True for a file that names the program, or whose first line may be that of a table without
/// notes.
bool may_be_own(const std::filesystem::path& file) {
    std::string line = first_bytes(file);
    line.resize(std::min(line.find('\n'), line.size()));
    constexpr std::string_view other_formats = "{|%\\"; // JSON, Markdown, LaTeX
    return line.find(',') != std::string::npos ||
           (!line.empty() && other_formats.find(line.front()) != std::string_view::npos &&
            !line.starts_with("%PDF")) ||
           contains_program(file);
}

void require(const std::filesystem::path& file, const std::function<bool()>& is_own_file) {
    struct stat found {};
    if (::stat(file.c_str(), &found) != 0 || found.st_size == 0) {
        return;
    }
    const std::lock_guard lock(inputs().mutex);
    if (inputs().all.contains({found.st_dev, found.st_ino})) {
        throw InputError(file.string() + " is an input of this command", "name another output");
    }
    if (!is_own_file()) {
        throw InputError(file.string() + " is there, and Edgeproof did not write it",
                         "remove it, or name another output");
    }
}

} // namespace

std::string first_bytes(const std::filesystem::path& file) {
    std::string head(4096, '\0');
    std::ifstream in(file, std::ios::binary);
    in.read(head.data(), static_cast<std::streamsize>(head.size()));
    head.resize(static_cast<std::size_t>(in.gcount()));
    return head;
}

void protect_inputs() { inputs().counted = true; }

void remember_input(const std::filesystem::path& file) {
    struct stat found {};
    if (inputs().counted && ::stat(file.c_str(), &found) == 0 && S_ISREG(found.st_mode)) {
        const std::lock_guard lock(inputs().mutex);
        inputs().all.emplace(found.st_dev, found.st_ino);
    }
}

void require_replaceable(const std::filesystem::path& file, std::string_view head) {
    require(file, [&] { return is_own(file, head); });
}

void require_replaceable(const std::filesystem::path& file) {
    require(file, [&] { return may_be_own(file); });
}

} // namespace edgeproof::io
