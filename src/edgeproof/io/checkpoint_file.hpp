// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace edgeproof::io {

/// The finished part of long work, stored next to its target. Entries are added piece by piece,
/// each piece with a checksum and in one write, and are read again after the program was stopped or
/// killed. An incomplete last piece is dropped. Only the positions of the pieces are kept in
/// memory.
class CheckpointFile {
public:
    /// Consecutive items of the work: the number of the first item, the number of items, the number
    /// of marked items, and their text.
    struct Entry {
        std::size_t index = 0;
        std::size_t items = 1;
        std::size_t marked = 0;
        std::string text;
    };

    /// Opens the file of the work with this `fingerprint`, in `pieces` pieces; a file of other work
    /// is started anew. Throws InputError if the file cannot be written, if another run has locked
    /// it, and if the name belongs to a link or to a file of another kind, which is not changed.
    CheckpointFile(std::filesystem::path file, std::uint64_t fingerprint, std::size_t pieces);
    ~CheckpointFile();
    CheckpointFile(const CheckpointFile&) = delete;
    CheckpointFile& operator=(const CheckpointFile&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return file_; }
    [[nodiscard]] bool has(std::size_t piece) const { return places_[piece].size > 0; }
    [[nodiscard]] std::size_t items() const { return items_; } ///< in all pieces
    [[nodiscard]] std::size_t marked() const { return marked_; }

    /// Returns entries as one text in the format of the file.
    [[nodiscard]] static std::string body(const std::vector<Entry>& entries);
    /// Adds a piece, given as its body. Throws InputError if it cannot be written (complete pieces
    /// are kept) or if the file is no longer in its folder, Error if the text is not a body.
    void add(std::size_t piece, const std::string& body);
    /// Returns the entries of a stored piece.
    [[nodiscard]] std::vector<Entry> piece(std::size_t number) const;
    void remove();

private:
    void read();
    void count(std::size_t piece, std::string_view body, std::uint64_t offset);
    [[nodiscard]] std::string at(std::uint64_t offset, std::size_t size) const;
    [[noreturn]] void not_ours() const;

    std::filesystem::path file_;
    int fd_ = -1;
    std::string head_;
    std::uint64_t end_ = 0; ///< the end of the complete pieces
    struct Place {
        std::uint64_t offset = 0; ///< position of the entries
        std::uint64_t size = 0;   ///< 0: the piece is missing
    };
    std::vector<Place> places_;
    std::size_t items_ = 0;
    std::size_t marked_ = 0;
};

} // namespace edgeproof::io
