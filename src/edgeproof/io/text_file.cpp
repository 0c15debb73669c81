// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/io/text_file.hpp"

#include "edgeproof/io/error_place.hpp"
#include "edgeproof/io/own_file.hpp"
#include "edgeproof/precision/error.hpp"

#include <boost/locale/utf.hpp>

#include <algorithm>
#include <atomic>
#include <fstream>
#include <iostream>
#include <iterator>
#include <optional>
#include <typeinfo>
#include <utility>

namespace edgeproof::io {
namespace {

constexpr std::string_view little_endian_mark = "\xFF\xFE";
constexpr std::string_view big_endian_mark = "\xFE\xFF";

namespace utf = boost::locale::utf;

void append_utf8(std::string& out, utf::code_point c) {
    utf::utf_traits<char>::encode(c, std::back_inserter(out));
}

bool is_valid(utf::code_point c) { return c != utf::illegal && c != utf::incomplete; }

/// Returns nothing if the text ends within a character, or contains half of a pair.
std::optional<std::string> utf8_from_utf16(std::string_view text) {
    if (text.size() % 2 != 0) {
        return {};
    }
    const std::size_t high = text.starts_with(big_endian_mark) ? 0 : 1;
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    std::u16string units;
    for (std::size_t at = 2; at < text.size(); at += 2) {
        units += static_cast<char16_t>(byte(at + high) << 8 | byte(at + 1 - high));
    }
    std::string out;
    for (auto at = units.cbegin(); at != units.cend();) {
        const utf::code_point c = utf::utf_traits<char16_t>::decode(at, units.cend());
        if (!is_valid(c)) {
            return {};
        }
        append_utf8(out, c);
    }
    return out;
}

} // namespace

std::string input_name(const std::filesystem::path& file) {
    return file == "-" ? "stdin" : file.string();
}

std::string read_text(const std::filesystem::path& file, const std::string& what,
                      std::size_t most) {
    const std::string name = input_name(file);
    const std::string give = "give the path of a " + what;
    const auto refuse = [&](const std::string& problem, const std::string& instead) {
        throw InputError(problem, instead).at(name, 0);
    };
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
        refuse(std::filesystem::is_symlink(file, error)
                   ? "this is a link to a file that is not there"
                   : "there is no such file",
               give);
    }
    // A pipe without a name (`<(command)`) has no canonical path. One with a name may never get a
    // writer, and opening it would wait for ever.
    if (!standard && std::filesystem::is_fifo(file, error) &&
        !std::filesystem::canonical(file, error).empty()) {
        refuse("this is a named pipe, not a file", "read it as standard input: - < " + name);
    }
    std::ifstream opened;
    if (!standard) {
        opened.open(file, std::ios::binary);
        remember_input(file);
    }
    std::istream& in = standard ? std::cin : opened;
    if (!in) {
        refuse("the file cannot be read", "check its permissions");
    }
    constexpr std::size_t block = 1U << 16U;
    std::string text;
    while (in) {
        const std::size_t had = text.size();
        text.resize(had + block);
        in.read(text.data() + had, block);
        text.resize(had + static_cast<std::size_t>(in.gcount()));
        if (text.size() > most) {
            refuse("the file holds more than " + std::to_string(most) + " bytes", give);
        }
    }
    if (in.bad()) {
        refuse("the file cannot be read", "check its permissions");
    }
    return text;
}

std::string lower_case(std::string_view text) {
    std::string lower(text);
    std::ranges::transform(lower, lower.begin(), [](char c) {
        return static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
    });
    return lower;
}

std::string_view trimmed(std::string_view text, std::string_view blanks) {
    const std::size_t from = text.find_first_not_of(blanks);
    return from == std::string_view::npos
               ? std::string_view{}
               : text.substr(from, text.find_last_not_of(blanks) - from + 1);
}

bool is_utf16(std::string_view text) {
    return text.starts_with(little_endian_mark) || text.starts_with(big_endian_mark);
}

std::string utf8_text(std::string text, const std::string& file) {
    if (!is_utf16(text)) {
        return text;
    }
    auto converted = utf8_from_utf16(text);
    if (!converted) {
        throw InputError("the file is in UTF-16 with an incomplete character", "save it in UTF-8")
            .at(file, 0);
    }
    return std::move(*converted);
}

bool is_utf8(std::string_view text) {
    for (auto at = text.begin(); at != text.end();) {
        if (!is_valid(utf::utf_traits<char>::decode(at, text.end()))) {
            return false;
        }
    }
    return true;
}

std::string utf8_from_latin1(std::string_view text) {
    std::string out;
    for (const char c : text) {
        append_utf8(out, static_cast<unsigned char>(c));
    }
    return out;
}

std::uint64_t fnv1a(std::string_view text, std::uint64_t before) {
    std::uint64_t hash = before;
    for (const char c : text) {
        hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
    }
    return hash;
}

void rethrow_at(const std::string& file, std::size_t line, std::string_view instead) {
    const auto advice = [&](std::string_view usual) {
        return std::string(instead.empty() ? usual : instead);
    };
    try {
        throw;
    } catch (const InputError& error) {
        if (!error.file().empty()) {
            throw;
        }
        throw InputError(error.problem(), error.instead().empty()
                                              ? advice("write it as the documentation has it")
                                              : error.instead())
            .at(file, line);
    } catch (const BudgetError& error) {
        throw InputError(error.what(), advice("ask for fewer digits, or write simpler numbers"))
            .at(file, line);
    } catch (const DomainError& error) {
        throw InputError(error.what(), advice("give values for which everything has a real value"))
            .at(file, line);
    } catch (const Error& error) {
        if (typeid(error) != typeid(Error)) { // a derived class has a meaning of its own
            throw;
        }
        throw InputError(error.what(),
                         advice("write numbers, x, + - * / ^, and functions such as sqrt and log"))
            .at(file, line);
    }
}

} // namespace edgeproof::io
