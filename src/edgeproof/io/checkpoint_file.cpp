// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/io/checkpoint_file.hpp"

#include "edgeproof/io/atomic_file.hpp"
#include "edgeproof/io/text_file.hpp"
#include "edgeproof/precision/error.hpp"

#include <fmt/format.h>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <optional>

namespace edgeproof::io {
namespace {

/// The beginning of such files of all versions: only such a file is overwritten or removed.
constexpr std::string_view first_words = "edgeproof part file ";

/// A hash that detects incomplete or accidentally changed text. It takes eight bytes at a time for
/// speed.
std::uint64_t hash_of_words(std::string_view text, std::uint64_t hash) {
    constexpr std::uint64_t odd = 0x9e3779b97f4a7c15U;
    for (std::size_t i = 0; i < text.size(); i += sizeof(std::uint64_t)) {
        std::uint64_t word = 0;
        std::memcpy(&word, text.data() + i, std::min(sizeof word, text.size() - i));
        hash = (hash ^ word) * odd;
        hash ^= hash >> 32U;
    }
    return hash;
}

/// The checksum of a piece includes its number, its size and its text.
std::uint64_t checksum(std::uint64_t piece, const std::string& body) {
    return hash_of_words(body, fnv1a(fmt::format("{} {} ", piece, body.size())));
}

/// Reads N numbers, separated by single blanks, to the end of the line.
template <std::size_t N>
std::optional<std::array<std::uint64_t, N>> numbers(std::string_view line, int base_of_last) {
    std::array<std::uint64_t, N> all{};
    const char* at = line.data();
    const char* const end = line.data() + line.size();
    for (std::size_t i = 0; i < N; ++i) {
        const auto [stop, error] = std::from_chars(at, end, all[i], i + 1 < N ? 10 : base_of_last);
        if (error != std::errc{} || (i + 1 < N ? stop == end || *stop != ' ' : stop != end)) {
            return {};
        }
        at = stop + 1;
    }
    return all;
}

/// Passes the entries of a piece's body to `take`; returns false if the text is not a body.
template <class Take> bool each_entry(std::string_view body, const Take& take) {
    for (std::size_t i = 0; i < body.size();) {
        const std::size_t stop = body.find('\n', i);
        const auto head = numbers<4>(body.substr(i, stop - i), 10);
        if (stop == std::string_view::npos || !head || (*head)[3] >= body.size() - stop) {
            return false;
        }
        const auto [index, items, marked, size] = *head;
        take(index, items, marked, body.substr(stop + 1, size));
        i = stop + 1 + size;
    }
    return true;
}

bool is_body(std::string_view body) {
    return each_entry(body, [](auto...) {});
}

} // namespace

CheckpointFile::CheckpointFile(std::filesystem::path file, std::uint64_t fingerprint,
                               std::size_t pieces)
    : file_(std::move(file)),
      // Links are not followed, and a FIFO does not block: the name may belong to another file.
      fd_(::open(file_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, 0666)),
      head_(fmt::format("{}4, {:016x}\n", first_words, fingerprint)), places_(pieces) {
    if (fd_ < 0) {
        if (errno == ELOOP || errno == EISDIR || errno == ENXIO) {
            not_ours();
        }
        cannot("write", file_, errno);
    }
    try {
        struct stat now {};
        if (::fstat(fd_, &now) != 0 || !S_ISREG(now.st_mode)) {
            not_ours();
        }
        if (::flock(fd_, LOCK_EX | LOCK_NB) != 0) {
            throw InputError(file_.string() + " is in use",
                             "wait for the other run, or name another file");
        }
        read();
    } catch (...) {
        ::close(fd_);
        throw;
    }
}

CheckpointFile::~CheckpointFile() {
    if (fd_ >= 0) {
        ::close(fd_);
    }
}

void CheckpointFile::not_ours() const {
    throw InputError(file_.string() + " is where the work that is done would be kept, and is not a "
                                      "file that Edgeproof made",
                     "rename it, or name another output file");
}

std::string CheckpointFile::at(std::uint64_t offset, std::size_t size) const {
    std::string text(size, '\0');
    std::size_t have = 0;
    while (have < size) {
        const ssize_t n =
            ::pread(fd_, text.data() + have, size - have, static_cast<off_t>(offset + have));
        if (n > 0) {
            have += static_cast<std::size_t>(n);
        } else if (n == 0 || errno != EINTR) {
            text.resize(have);
            break;
        }
    }
    return text;
}

// A piece is a line "piece BYTES CHECKSUM", then for each entry a line "INDEX ITEMS MARKED BYTES"
// and its text.
void CheckpointFile::read() {
    end_ = head_.size();
    constexpr std::size_t longest_head = 80;
    const std::string begins = at(0, head_.size());
    // A file of an older version, of another recipe, or with an incomplete first line is started
    // anew.
    const std::size_t known = std::min(begins.size(), first_words.size());
    if (begins.compare(0, known, first_words, 0, known) != 0) {
        not_ours();
    }
    const bool ours = begins == head_;
    while (ours) {
        const std::string line = at(end_, longest_head);
        const std::size_t newline = line.find('\n');
        const auto head = newline == std::string::npos
                              ? std::nullopt
                              : numbers<3>(std::string_view(line).substr(0, newline), 16);
        if (!head || (*head)[0] >= places_.size() || has((*head)[0]) || (*head)[1] == 0) {
            break;
        }
        const std::uint64_t begin = end_ + newline + 1;
        const std::string body = at(begin, (*head)[1]);
        if (body.size() != (*head)[1] || checksum((*head)[0], body) != (*head)[2]) {
            break;
        }
        if (!is_body(body)) {
            break;
        }
        count((*head)[0], body, begin);
        end_ = begin + body.size();
    }
    const std::uint64_t keep = ours ? end_ : 0;
    if (::ftruncate(fd_, static_cast<off_t>(keep)) != 0 ||
        ::lseek(fd_, static_cast<off_t>(keep), SEEK_SET) < 0) {
        cannot("write", file_, errno);
    }
    if (!ours) {
        if (const int error = write_all(fd_, head_); error != 0) {
            ::unlink(file_.c_str());
            cannot("write", file_, error);
        }
    }
}

void CheckpointFile::count(std::size_t piece, std::string_view body, std::uint64_t offset) {
    (void)each_entry(body, [&](std::size_t, std::size_t items, std::size_t marked, auto) {
        items_ += items;
        marked_ += marked;
    });
    places_[piece] = {offset, body.size()};
}

std::string CheckpointFile::body(const std::vector<Entry>& entries) {
    std::string text;
    for (const Entry& e : entries) {
        text += fmt::format("{} {} {} {}\n", e.index, e.items, e.marked, e.text.size());
        text += e.text;
    }
    return text;
}

void CheckpointFile::add(std::size_t piece, const std::string& body) {
    if (body.empty() || !is_body(body) || piece >= places_.size() || has(piece)) {
        throw Error(
            fmt::format("piece {} of {} is not one that was asked for", piece, file_.string()));
    }
    const std::string head = fmt::format("{} {} {:x}\n", piece, body.size(), checksum(piece, body));
    struct stat now {};
    if (::fstat(fd_, &now) != 0 || now.st_nlink == 0) {
        throw InputError(file_.string() + " has been removed while it was written",
                         give_writable_folder);
    }
    if (const int error = write_all(fd_, head + body); error != 0) {
        (void)::ftruncate(fd_, static_cast<off_t>(end_));
        cannot("write", file_, error);
    }
    count(piece, body, end_ + head.size());
    end_ += head.size() + body.size();
}

std::vector<CheckpointFile::Entry> CheckpointFile::piece(std::size_t number) const {
    const std::string body = at(places_[number].offset, places_[number].size);
    std::vector<Entry> entries;
    const bool whole = each_entry(
        body, [&](std::size_t index, std::size_t items, std::size_t marked, std::string_view text) {
            entries.push_back({index, items, marked, std::string(text)});
        });
    if (body.size() != places_[number].size || !whole) {
        cannot("read", file_, EIO);
    }
    return entries;
}

void CheckpointFile::remove() {
    // Removes only this file: another file may have its name now.
    struct stat mine {};
    struct stat named {};
    if (::fstat(fd_, &mine) == 0 && ::lstat(file_.c_str(), &named) == 0 &&
        mine.st_dev == named.st_dev && mine.st_ino == named.st_ino) {
        ::unlink(file_.c_str());
    }
}

} // namespace edgeproof::io
