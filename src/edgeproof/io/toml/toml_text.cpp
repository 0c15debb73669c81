// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/io/toml/toml_text.hpp"
#include "edgeproof/precision/error.hpp"

#include <cctype>
#include <string>

namespace edgeproof::io {

std::vector<std::string_view> split_words(std::string_view text) {
    std::vector<std::string_view> words;
    for (std::size_t end = text.find(' '); end != std::string_view::npos; end = text.find(' ')) {
        words.push_back(text.substr(0, end));
        text.remove_prefix(end + 1);
    }
    words.push_back(text);
    return words;
}

std::vector<std::string> split_lines(std::string_view text) {
    std::vector<std::string> lines;
    while (!text.empty()) {
        const std::size_t end = text.find('\n');
        lines.emplace_back(text.substr(0, end));
        text = end == std::string_view::npos ? std::string_view{} : text.substr(end + 1);
    }
    return lines;
}

std::size_t significant_digits(std::string_view number) {
    std::size_t digits = 0;
    for (const char c : number.substr(0, number.find_first_of("eE"))) {
        digits += c >= '0' && c <= '9' && (digits > 0 || c != '0') ? 1 : 0;
    }
    return digits;
}

bool is_number_character(char c) {
    return (c >= '0' && c <= '9') || c == '+' || c == '-' || c == '.' || c == 'e' || c == 'E' ||
           c == '_';
}

std::size_t byte_of_column(std::string_view line, std::size_t column) {
    std::size_t at = 0;
    for (std::size_t before = 1; before < column && at < line.size(); ++before) {
        ++at;
        while (at < line.size() && (static_cast<unsigned char>(line[at]) & 0xC0U) == 0x80U) {
            ++at;
        }
    }
    return at;
}

bool has_control(std::string_view text) {
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto c = static_cast<unsigned char>(text[i]);
        const bool c1 = c == 0xC2U && i + 1 < text.size() &&
                        static_cast<unsigned char>(text[i + 1]) < 0xA0U; // U+0080 ... U+009F
        if ((c < 0x20U && c != '\t' && c != '\n' && c != '\r') || c == 0x7FU || c1) {
            return true;
        }
    }
    return false;
}

namespace {

/// True for a character of a name, or of the quotes around it.
bool is_of_name(char c) {
    const auto byte = static_cast<unsigned char>(c);
    return std::isalnum(byte) != 0 || byte >= 0x80U || c == '_' || c == '-' || c == '"' ||
           c == '\'';
}

} // namespace

void check_toml_limits(std::string_view text, const std::string& file) {
    if (text.size() > most_toml_bytes) {
        throw InputError("the file holds " + std::to_string(text.size()) + " bytes",
                         "write a TOML file of at most " + std::to_string(most_toml_bytes))
            .at(file, 1);
    }
    std::size_t line = 1;
    std::size_t dots = 0; // between names without a blank in them
    char before = ' ';    // the last character that is no blank
    bool blank = true;    // one stands between
    for (const char c : text) {
        line += c == '\n' ? 1 : 0;
        if (c == ' ' || c == '\t') {
            blank = true;
            continue;
        }
        if (c == '.' && is_of_name(before)) {
            ++dots;
        } else if (!is_of_name(c) || (blank && is_of_name(before))) {
            dots = 0;
        }
        if (dots >= most_toml_nesting) {
            throw InputError("a key joins names by dots, more than " +
                                 std::to_string(most_toml_nesting) + " levels deep",
                             "write key = \"value\" lines under [section] headers")
                .at(file, line);
        }
        before = c;
        blank = false;
    }
}

} // namespace edgeproof::io
