// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cli/shipped_file.hpp"

#include <filesystem>

namespace edgeproof::cli {

std::string file_or_shipped(const std::string& given, std::string_view folder) {
    std::error_code failed;
    if (given.empty() || given.find_first_of("./") != std::string::npos ||
        std::filesystem::exists(given, failed)) {
        return given;
    }
    const auto self = std::filesystem::read_symlink("/proc/self/exe", failed);
    const auto file = (self.parent_path() / EDGEPROOF_DATA_FOLDER / folder / (given + ".toml"))
                          .lexically_normal();
    return std::filesystem::exists(file, failed) ? file.string() : given;
}

} // namespace edgeproof::cli
