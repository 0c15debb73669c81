// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/cli/cli.hpp"

#include <algorithm>
#include <filesystem>
#include <string>
#include <string_view>

namespace edgeproof::cli {

std::filesystem::path installed(const std::filesystem::path& file) {
    std::error_code failed;
    const auto self = std::filesystem::read_symlink("/proc/self/exe", failed);
    return (self.parent_path() / file).lexically_normal();
}

std::filesystem::path shipped(std::string_view folder) {
    return installed(std::filesystem::path(EDGEPROOF_DATA_FOLDER) / folder);
}

std::string file_or_shipped(const std::string& given, std::string_view folder) {
    std::error_code failed;
    if (given.empty() || given.find_first_of("./") != std::string::npos ||
        std::filesystem::exists(std::filesystem::symlink_status(given, failed))) {
        return given;
    }
    const auto file = shipped(folder) / (given + ".toml");
    return std::filesystem::exists(file, failed) ? file.string() : given;
}

std::vector<std::string> shipped_names(std::string_view folder) {
    std::vector<std::string> names;
    std::error_code failed;
    for (const auto& entry : std::filesystem::directory_iterator(shipped(folder), failed)) {
        if (entry.path().extension() == ".toml") {
            names.push_back(entry.path().stem().string());
        }
    }
    std::ranges::sort(names);
    return names;
}

} // namespace edgeproof::cli
