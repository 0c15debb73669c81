// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/io/text_file.hpp"

#include "edgeproof/precision/error.hpp"

#include <atomic>
#include <fstream>
#include <iostream>
#include <string>

namespace edgeproof::io {

std::string input_name(const std::filesystem::path& file) {
    return file == "-" ? "stdin" : file.string();
}

std::string read_text(const std::filesystem::path& file, const std::string& what,
                      std::size_t most) {
    const auto refuse = [&](const std::string& problem, const std::string& instead) {
        throw InputError(problem, instead).at(input_name(file), 0);
    };
    const std::string give = "give the path of a " + what;
    const bool standard = file == "-";
    static std::atomic<bool> taken = false;
    if (standard && taken.exchange(true)) {
        refuse("standard input has been read already", give + " where - stands again");
    }
    std::error_code error;
    if (!standard && std::filesystem::is_directory(file, error)) {
        refuse("this is a folder, not a file", give);
    }
    if (!standard && !std::filesystem::exists(file, error)) {
        refuse("there is no such file", give);
    }
    std::ifstream opened;
    if (!standard) {
        opened.open(file, std::ios::binary);
    }
    std::istream& in = standard ? std::cin : opened;
    if (!in) {
        refuse("the file cannot be read", "check its permissions");
    }
    constexpr std::size_t block = 1U << 16U;
    std::string text;
    while (in && text.size() <= most) {
        const std::size_t had = text.size();
        text.resize(had + block);
        in.read(text.data() + had, static_cast<std::streamsize>(block));
        text.resize(had + static_cast<std::size_t>(in.gcount()));
    }
    if (in.bad()) {
        refuse("the file cannot be read", "check its permissions");
    }
    if (text.size() > most) {
        refuse("the file holds more than " + std::to_string(most) + " bytes", give);
    }
    return text;
}

std::uint64_t fnv1a(std::string_view text, std::uint64_t before) {
    std::uint64_t hash = before;
    for (const char c : text) {
        hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
    }
    return hash;
}

} // namespace edgeproof::io
