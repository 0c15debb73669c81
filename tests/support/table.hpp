// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tests/support/paths.hpp"

#include <doctest/doctest.h>

#include <fstream>
#include <string>
#include <vector>

/// Texts and tables of tests.
namespace edgeproof::test {

/// The parts of a text between a separator.
inline std::vector<std::string> parts(const std::string& text, const std::string& by) {
    std::vector<std::string> all;
    std::size_t from = 0;
    for (std::size_t at = 0; (at = text.find(by, from)) != std::string::npos;
         from = at + by.size()) {
        all.push_back(text.substr(from, at - from));
    }
    all.push_back(text.substr(from));
    return all;
}

inline std::string repeated(const std::string& text, std::size_t times) {
    std::string all;
    for (std::size_t i = 0; i < times; ++i) {
        all += text;
    }
    return all;
}

/// The text with the first occurrence of `from` replaced.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
}

/// A line of a table, and where it stands: FILE:LINE.
struct TableLine {
    std::string place;
    std::string text;
};

/// The lines of a table of the folder tests, without notes (#) and empty lines. A backslash at the
/// end continues a line.
inline std::vector<TableLine> table_lines(const std::string& file) {
    std::ifstream in(source_dir() / "tests" / file);
    std::vector<TableLine> lines;
    std::size_t number = 0;
    for (std::string line; std::getline(in, line);) {
        const std::string place = "tests/" + file + ":" + std::to_string(++number);
        for (std::string more; line.ends_with('\\') && std::getline(in, more); ++number) {
            line = line.substr(0, line.size() - 1) + more;
        }
        if (line.find_first_not_of(' ') != std::string::npos && !line.starts_with('#')) {
            lines.push_back({place, line});
        }
    }
    return lines;
}

/// The texts of a block: each line has one, or several with two blanks or more between them.
inline std::vector<std::string> items(const std::string& block) {
    std::vector<std::string> all;
    for (const std::string& line : parts(block, "\n")) {
        for (std::size_t at = line.find_first_not_of(' '); at != std::string::npos;) {
            const std::size_t end = line.find("  ", at);
            all.push_back(line.substr(at, end - at));
            at = line.find_first_not_of(' ', end);
        }
    }
    return all;
}

/// Calls check(x, y) for each item "x SIGN y" of a block.
template <class Check>
void for_pairs(const std::string& block, const std::string& sign, const Check& check) {
    for (const std::string& item : items(block)) {
        CAPTURE(item);
        const std::size_t at = item.find(sign);
        check(item.substr(0, at), item.substr(at + sign.size()));
    }
}

} // namespace edgeproof::test
