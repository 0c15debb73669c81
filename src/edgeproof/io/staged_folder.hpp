// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <filesystem>
#include <functional>

namespace edgeproof::io {

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

} // namespace edgeproof::io
