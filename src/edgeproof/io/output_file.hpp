// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/io/process.hpp"

#include <concepts>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace edgeproof::io {

/// Writes a file that others see only when it is complete: until then it has no name, or, if the
/// file system does not support that, a temporary one. A missing folder is created. Throws
/// InputError if the file cannot be written or replaced (require_replaceable), Interrupted after an
/// interruption; no text remains then. A link is kept, and its target is written; an existing file
/// keeps its permissions; a device, a FIFO or an open descriptor is written directly.
void write_whole(const std::filesystem::path& file, const std::string& text);

void write_output(const std::filesystem::path& file, const std::string& text);

/// Flushes standard output. Throws InputError if any of it, now or earlier, could not be written.
void finish_standard_output();

/// Throws InputError if the file cannot be written or must not be replaced (require_replaceable()),
/// as far as can be checked beforehand; for use before long work. Creates nothing. "-" is standard
/// output; an empty name is no file.
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
/// cannot be written or must not be replaced (require_replaceable()), or if files vanish meanwhile;
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

inline constexpr const char* give_writable_folder =
    "give a folder that can be written to, with free space";

/// Throws InputError: "cannot WHAT PATH: the text of the error number".
[[noreturn]] void cannot(const std::string& what, const std::filesystem::path& path, int error);

/// Returns a name next to a file or folder that no other process uses
/// ("t.csv.0123456789abcdef.tmp").
[[nodiscard]] std::filesystem::path temporary_name(const std::filesystem::path& target);

/// The files that did not exist before write_whole() of this process wrote them.
[[nodiscard]] std::size_t files_created();

// No output replaces a file of the user.

/// Returns the beginning of a file.
[[nodiscard]] std::string first_bytes(const std::filesystem::path& file);

/// From now on, no file that this process reads is replaced. For a process that runs one command.
void protect_inputs();

/// Called with each file that this process reads.
void remember_input(const std::filesystem::path& file);

/// Throws InputError if a text that begins with `head` must not replace the file: it is an
/// input (protect_inputs), or it is neither empty nor written by this program. A file that this
/// program wrote contains its name and version as program_line() has them, or, without them, begins
/// like the new text.
void require_replaceable(const std::filesystem::path& file, std::string_view head);

/// Throws InputError if no text may replace the file, also no table without notes, which only its
/// beginning identifies. For use before long work.
void require_replaceable(const std::filesystem::path& file);

} // namespace edgeproof::io
