// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/io/text_file.hpp"
#include "edgeproof/io/output_file.hpp"
#include "edgeproof/precision/error.hpp"

#include <boost/locale/encoding_utf.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <fstream>
#include <iostream>
#include <typeinfo>
#include <utility>

namespace edgeproof::io {

namespace {

constexpr std::string_view little_endian_mark = "\xFF\xFE";
constexpr std::string_view big_endian_mark = "\xFE\xFF";

namespace conv = boost::locale::conv;

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

std::string_view trimmed(std::string_view text, std::string_view blanks) {
    const std::size_t from = text.find_first_not_of(blanks);
    return from == std::string_view::npos
               ? std::string_view{}
               : text.substr(from, text.find_last_not_of(blanks) - from + 1);
}

std::vector<std::string_view> split_words(std::string_view text) {
    constexpr std::string_view blanks = " \t\r\n";
    std::vector<std::string_view> words;
    while (!(text = trimmed(text, blanks)).empty()) {
        words.push_back(text.substr(0, text.find_first_of(blanks)));
        text.remove_prefix(words.back().size());
    }
    return words;
}

bool is_utf16(std::string_view text) {
    return text.starts_with(little_endian_mark) || text.starts_with(big_endian_mark);
}

std::string utf8_text(std::string text, const std::string& file) {
    if (!is_utf16(text)) {
        return text;
    }
    const std::size_t high = text.starts_with(big_endian_mark) ? 0 : 1;
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    std::u16string units;
    for (std::size_t at = 2; at + 1 < text.size(); at += 2) {
        units += static_cast<char16_t>(byte(at + high) << 8 | byte(at + 1 - high));
    }
    try {
        if (text.size() % 2 == 0) {
            return conv::utf_to_utf<char>(units, conv::stop);
        }
    } catch (const conv::conversion_error&) { // half of a pair
    }
    throw InputError("the file is in UTF-16 with an incomplete character", "save it in UTF-8")
        .at(file, 0);
}

bool is_utf8(std::string_view text) {
    namespace utf = boost::locale::utf;
    for (auto at = text.begin(); at != text.end();) {
        const utf::code_point c = utf::utf_traits<char>::decode(at, text.end());
        if (c == utf::illegal || c == utf::incomplete) {
            return false;
        }
    }
    return true;
}

std::string utf8_from_latin1(std::string_view text) {
    std::u32string letters;
    for (const char c : text) {
        letters += static_cast<unsigned char>(c);
    }
    return conv::utf_to_utf<char>(letters);
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

namespace {

// The first 32 bits of the fractional parts of the cube roots of the first 64 primes.
constexpr std::array<std::uint32_t, 64> round_constants{
    0x428a2f98, 0x71374491, 0xb5c0fbcf, 0xe9b5dba5, 0x3956c25b, 0x59f111f1, 0x923f82a4, 0xab1c5ed5,
    0xd807aa98, 0x12835b01, 0x243185be, 0x550c7dc3, 0x72be5d74, 0x80deb1fe, 0x9bdc06a7, 0xc19bf174,
    0xe49b69c1, 0xefbe4786, 0x0fc19dc6, 0x240ca1cc, 0x2de92c6f, 0x4a7484aa, 0x5cb0a9dc, 0x76f988da,
    0x983e5152, 0xa831c66d, 0xb00327c8, 0xbf597fc7, 0xc6e00bf3, 0xd5a79147, 0x06ca6351, 0x14292967,
    0x27b70a85, 0x2e1b2138, 0x4d2c6dfc, 0x53380d13, 0x650a7354, 0x766a0abb, 0x81c2c92e, 0x92722c85,
    0xa2bfe8a1, 0xa81a664b, 0xc24b8b70, 0xc76c51a3, 0xd192e819, 0xd6990624, 0xf40e3585, 0x106aa070,
    0x19a4c116, 0x1e376c08, 0x2748774c, 0x34b0bcb5, 0x391c0cb3, 0x4ed8aa4a, 0x5b9cca4f, 0x682e6ff3,
    0x748f82ee, 0x78a5636f, 0x84c87814, 0x8cc70208, 0x90befffa, 0xa4506ceb, 0xbef9a3f7, 0xc67178f2};

using State = std::array<std::uint32_t, 8>;

void take_block(State& state, std::string_view block) {
    std::array<std::uint32_t, 64> w{};
    for (std::size_t i = 0; i < 16; ++i) {
        for (std::size_t k = 0; k < 4; ++k) {
            w[i] = w[i] << 8U | static_cast<unsigned char>(block[4 * i + k]);
        }
    }
    for (std::size_t i = 16; i < 64; ++i) {
        const std::uint32_t s0 =
            std::rotr(w[i - 15], 7) ^ std::rotr(w[i - 15], 18) ^ w[i - 15] >> 3U;
        const std::uint32_t s1 =
            std::rotr(w[i - 2], 17) ^ std::rotr(w[i - 2], 19) ^ w[i - 2] >> 10U;
        w[i] = w[i - 16] + s0 + w[i - 7] + s1;
    }
    auto [a, b, c, d, e, f, g, h] = state;
    for (std::size_t i = 0; i < 64; ++i) {
        const std::uint32_t s1 = std::rotr(e, 6) ^ std::rotr(e, 11) ^ std::rotr(e, 25);
        const std::uint32_t t1 = h + s1 + ((e & f) ^ (~e & g)) + round_constants[i] + w[i];
        const std::uint32_t s0 = std::rotr(a, 2) ^ std::rotr(a, 13) ^ std::rotr(a, 22);
        const std::uint32_t t2 = s0 + ((a & b) ^ (a & c) ^ (b & c));
        h = g;
        g = f;
        f = e;
        e = d + t1;
        d = c;
        c = b;
        b = a;
        a = t1 + t2;
    }
    const State sum{a, b, c, d, e, f, g, h};
    for (std::size_t i = 0; i < 8; ++i) {
        state[i] += sum[i];
    }
}

} // namespace

std::string sha256(std::string_view text) {
    State state{0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
    constexpr std::size_t block = 64;
    const std::size_t whole = text.size() / block * block;
    for (std::size_t at = 0; at < whole; at += block) {
        take_block(state, text.substr(at, block));
    }
    std::string rest(text.substr(whole));
    rest += '\x80';
    rest.resize((rest.size() + 8 + block - 1) / block * block - 8, '\0');
    const std::uint64_t bits = 8 * static_cast<std::uint64_t>(text.size());
    for (int shift = 56; shift >= 0; shift -= 8) {
        rest += static_cast<char>(bits >> static_cast<unsigned>(shift) & 0xffU);
    }
    for (std::size_t at = 0; at < rest.size(); at += block) {
        take_block(state, std::string_view(rest).substr(at, block));
    }
    std::string hex;
    for (const std::uint32_t word : state) {
        for (int shift = 28; shift >= 0; shift -= 4) {
            hex += "0123456789abcdef"[word >> static_cast<unsigned>(shift) & 0xfU];
        }
    }
    return hex;
}

} // namespace edgeproof::io
