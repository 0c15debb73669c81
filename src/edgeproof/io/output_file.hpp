// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
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

/// True for a name of a file, without its ending, that stays in its folder and that no shell reads
/// in another way: letters, digits, '-', '_' and '.', no '.' or '-' in front, at most 120 bytes.
[[nodiscard]] bool is_file_stem(std::string_view name);

} // namespace edgeproof::io
