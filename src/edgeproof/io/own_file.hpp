// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <filesystem>
#include <string>
#include <string_view>

namespace edgeproof::io {

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
