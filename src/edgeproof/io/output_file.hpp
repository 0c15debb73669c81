// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <filesystem>
#include <string>

namespace edgeproof::io {

/// Writes the text beside `file` and renames it (its folder is made where there is none): a reader
/// sees the old file or the whole new one, whatever happens in between. Throws InputError where it
/// cannot be written (the part written is removed), Interrupted where that was asked for.
void write_whole(const std::filesystem::path& file, const std::string& text);

/// The same for the state that work goes on from: written in an interrupted process as well.
void write_checkpoint(const std::filesystem::path& file, const std::string& text);

/// To the file, or for "-" to standard output.
void write_output(const std::filesystem::path& file, const std::string& text);

/// Sends what was printed to standard output on its way. Throws InputError where some of it, now or
/// before, could not be written.
void finish_standard_output();

/// Throws InputError where the file could not be written, as far as can be told beforehand: to be
/// called before the work that it waits for. Makes nothing. "-" is standard output, and an empty
/// name none.
void check_output(const std::filesystem::path& file);

/// Makes a folder (and those above it). Throws InputError where that cannot be done, or where
/// nothing can be written into it.
void make_folder(const std::filesystem::path& folder);

/// Throws InputError where make_folder would, as far as can be told beforehand; makes nothing: for
/// a folder that is made by what is written into it, once there is something to write.
void check_folder(const std::filesystem::path& folder);

} // namespace edgeproof::io
