// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace edgeproof::io {

/// What is done of long work, kept beside its target: entries are added piece by piece, each piece
/// with a checksum and in one go, and found again after the program was stopped or killed. The last
/// piece, where it is torn, is dropped. Only the places of pieces are kept in memory.
class CheckpointFile {
public:
    /// What stands together in the whole: the number of its first item, how many items it is made
    /// of, how many of them are marked, and their text.
    struct Entry {
        std::size_t index = 0;
        std::size_t items = 1;
        std::size_t marked = 0;
        std::string text;
    };

    /// Opens what there is of the work that `fingerprint` tells from any other, in `pieces` pieces;
    /// else begins anew. Throws InputError where the file cannot be written, where another run
    /// holds it, and where what has its name is a link or not a file of this kind: that is left
    /// alone.
    CheckpointFile(std::filesystem::path file, std::uint64_t fingerprint, std::size_t pieces);
    ~CheckpointFile();
    CheckpointFile(const CheckpointFile&) = delete;
    CheckpointFile& operator=(const CheckpointFile&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return file_; }
    [[nodiscard]] bool has(std::size_t piece) const { return places_[piece].size > 0; }
    [[nodiscard]] std::size_t items() const { return items_; } ///< that there are
    [[nodiscard]] std::size_t marked() const { return marked_; }

    /// Entries as one text, as it stands in the file.
    [[nodiscard]] static std::string body(const std::vector<Entry>& entries);
    /// Adds a piece, given as its body. Throws InputError where it cannot be written (what was
    /// whole before is kept) and where the file is no longer in its folder, Error where it is no
    /// body.
    void add(std::size_t piece, const std::string& body);
    /// A piece that there is, as it was added.
    [[nodiscard]] std::vector<Entry> piece(std::size_t number) const;
    /// Deletes the file.
    void remove();

private:
    void read();
    void count(std::size_t piece, std::string_view body, std::uint64_t offset);
    [[nodiscard]] std::string at(std::uint64_t offset, std::size_t size) const;
    [[noreturn]] void cannot(const char* what, int error) const;
    [[noreturn]] void not_ours() const;

    std::filesystem::path file_;
    int fd_ = -1;
    std::string head_;
    std::uint64_t end_ = 0; ///< of what is whole
    struct Place {
        std::uint64_t offset = 0; ///< of the entries
        std::uint64_t size = 0;   ///< 0: not there
    };
    std::vector<Place> places_;
    std::size_t items_ = 0;
    std::size_t marked_ = 0;
};

} // namespace edgeproof::io
