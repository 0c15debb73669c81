// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <concepts>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace edgeproof::io {

/// Writes the text to a temporary file and renames it to `file` (a missing folder is created), so
/// that a reader sees either the old file or the complete new one. Throws InputError if it cannot
/// be written (the part written is removed), Interrupted after an interruption.
void write_whole(const std::filesystem::path& file, const std::string& text);

void write_output(const std::filesystem::path& file, const std::string& text);

/// Flushes standard output. Throws InputError if any of it, now or earlier, could not be written.
void finish_standard_output();

/// Throws InputError if the file cannot be written or must not be replaced (own_file.hpp), as far
/// as can be checked beforehand; for use before long work. Creates nothing. "-" is standard output;
/// an empty name is no file.
void check_output(const std::filesystem::path& file);

/// Makes a folder (and its parents). Throws InputError if that fails, or if the folder is not
/// writable.
void make_folder(const std::filesystem::path& folder);

/// Throws InputError if make_folder would fail, as far as can be checked beforehand. Creates
/// nothing: for a folder that is created only when there is something to write.
void check_folder(const std::filesystem::path& folder);

/// Writes the files of one result, which appear together: `write` writes them into a temporary
/// folder, which then becomes the target, or whose files are moved into the target if that exists.
/// If that fails, the target remains as it was. Throws InputError (in the target's names) if a file
/// cannot be written or must not be replaced (own_file.hpp), or if files vanish meanwhile;
/// Interrupted. For a check before long work: check_folder.
///
/// Only SIGKILL or a loss of power can leave the temporary folder ("out.0123456789abcdef.tmp"), or,
/// within some microseconds, files of two runs. No run removes a folder that it did not make.
void write_folder(const std::filesystem::path& target,
                  const std::function<void(const std::filesystem::path&)>& write);

/// The name, without extension, of a file made for an id of the input. The name always stays in its
/// folder: only letters, digits, '-', '_' and '.', no '.' or '-' in front, and at most `most_bytes`
/// bytes. An id of this form is its own name. Any other id is changed to this form and ends with
/// '-' and 16 hexadecimal digits of its SHA-256, so that different ids have different names.
class FileStem {
public:
    static constexpr std::size_t most_bytes = 120;

    FileStem() : FileStem(std::string_view("unnamed")) {}
    template <std::convertible_to<std::string_view> Text>
    FileStem(const Text& id) // NOLINT(google-explicit-constructor): safe for every text
        : FileStem(std::string_view(id)) {}
    FileStem(std::string_view id); // NOLINT(google-explicit-constructor)

    [[nodiscard]] const std::string& text() const noexcept { return text_; }
    /// Returns, for example, "ID.svg".
    [[nodiscard]] std::string with(std::string_view ending) const {
        return text_ + std::string(ending);
    }
    friend bool operator==(const FileStem&, const FileStem&) = default;

private:
    std::string text_;
};

} // namespace edgeproof::io
