// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/report/files.hpp"

#include "edgeproof/conformance/whole_file.hpp"
#include "edgeproof/precision/error.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace edgeproof {
namespace {

[[noreturn]] void cannot(const std::string& what, const std::filesystem::path& path, int error) {
    throw InputError("cannot " + what + " " + path.string() + ": " + std::strerror(error),
                     make_room);
}

} // namespace

void write_whole(const std::filesystem::path& file, const std::string& text) {
    WholeFile whole(file);
    whole.write(text);
    whole.commit();
}

void write_checkpoint(const std::filesystem::path& file, const std::string& text) {
    WholeFile whole(file, WholeFile::Content::checkpoint);
    whole.write(text);
    whole.commit();
}

void make_folder(const std::filesystem::path& folder) {
    std::error_code failed;
    std::filesystem::create_directories(folder, failed);
    if (failed) {
        cannot("make the folder", folder, failed.value());
    }
    if (::access(folder.c_str(), W_OK | X_OK) != 0) {
        cannot("write into", folder, errno);
    }
}

} // namespace edgeproof
