// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/conformance/text_file.hpp"

#include "edgeproof/precision/error.hpp"

#include <fstream>
#include <sstream>

namespace edgeproof {

std::string read_text(const std::filesystem::path& file, const std::string& what) {
    std::error_code error;
    if (!std::filesystem::exists(file, error) || std::filesystem::is_directory(file, error)) {
        throw InputError("there is no such file", "give the path of a " + what)
            .at(file.string(), 0);
    }
    std::ifstream in(file, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    if (!in || in.bad()) {
        throw InputError("the file cannot be read", "check its permissions").at(file.string(), 0);
    }
    return text.str();
}

std::uint64_t fnv1a(std::string_view text, std::uint64_t before) {
    std::uint64_t hash = before;
    for (const char c : text) {
        hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
    }
    return hash;
}

} // namespace edgeproof
