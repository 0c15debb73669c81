// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <filesystem>
#include <string>

namespace edgeproof::io {

/// Writes the text to a temporary file and renames it to `file` (a missing folder is created), so
/// that a reader sees either the old file or the complete new one. Throws InputError if it cannot
/// be written (the part written is removed), Interrupted after an interruption.
void write_whole(const std::filesystem::path& file, const std::string& text);

/// Like write_whole, for a state from which work continues: also written in an interrupted process.
void write_checkpoint(const std::filesystem::path& file, const std::string& text);

void write_output(const std::filesystem::path& file, const std::string& text);

/// Flushes standard output. Throws InputError if any of it, now or earlier, could not be written.
void finish_standard_output();

/// Throws InputError if the file cannot be written, as far as can be checked beforehand; for use
/// before long work. Creates nothing. "-" is standard output; an empty name is no file.
void check_output(const std::filesystem::path& file);

/// Makes a folder (and its parents). Throws InputError if that fails, or if the folder is not
/// writable.
void make_folder(const std::filesystem::path& folder);

/// Throws InputError if make_folder would fail, as far as can be checked beforehand. Creates
/// nothing: for a folder that is created only when there is something to write.
void check_folder(const std::filesystem::path& folder);

} // namespace edgeproof::io
