// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/io/toml/toml_text.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>

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

class NestingScan {
public:
    NestingScan(std::string_view text, const std::string& file) : text_(text), file_(file) {}

    void run() {
        while (at_ < text_.size()) {
            const char c = text_[at_];
            if (c == '"' || c == '\'') {
                skip_string(c);
                continue;
            }
            if (c == '#') {
                at_ = std::min(text_.find('\n', at_), text_.size());
                continue;
            }
            step(c);
            ++at_;
        }
    }

private:
    void step(char c) {
        switch (c) {
        case '\n':
            ++line_;
            dots_ = 0;
            break;
        case '[':
        case '{':
            dots_ = 0;
            if (++open_ > most_toml_nesting) {
                reject("brackets are nested more than ");
            }
            break;
        case ']':
        case '}':
            dots_ = 0;
            open_ -= open_ > 0 ? 1 : 0;
            break;
        case '=':
        case ',':
            dots_ = 0;
            break;
        case '.':
            if (++dots_ >= most_toml_nesting) {
                reject("a key joins names by dots, more than ");
            }
            break;
        default:
            break;
        }
    }

    /// Skips the string that begins here, on one line or several.
    void skip_string(char quote) {
        const std::string three(3, quote);
        if (!text_.substr(at_).starts_with(three)) {
            ++at_;
            while (at_ < text_.size() && text_[at_] != quote && text_[at_] != '\n') {
                at_ += quote == '"' && text_[at_] == '\\' ? 2 : 1;
            }
            at_ += at_ < text_.size() && text_[at_] == quote ? 1 : 0; // a newline also ends it
            return;
        }
        at_ += three.size();
        while (at_ < text_.size() && !text_.substr(at_).starts_with(three)) {
            line_ += text_[at_] == '\n' ? 1 : 0;
            const bool escape = quote == '"' && text_[at_] == '\\';
            line_ += escape && at_ + 1 < text_.size() && text_[at_ + 1] == '\n' ? 1 : 0;
            at_ += escape ? 2 : 1;
        }
        at_ += three.size();
        // Up to two more quotes belong to the string.
        for (int more = 0; more < 2 && at_ < text_.size() && text_[at_] == quote; ++more) {
            ++at_;
        }
    }

    [[noreturn]] void reject(const std::string& what) const {
        throw InputError(what + std::to_string(most_toml_nesting) + " levels deep",
                         "write key = \"value\" lines under [section] headers")
            .at(file_, line_);
    }

    std::string_view text_;
    const std::string& file_;
    std::size_t at_ = 0;
    std::size_t line_ = 1;
    std::size_t open_ = 0; ///< open brackets
    std::size_t dots_ = 0; ///< of the current key
};

} // namespace

void check_toml_limits(std::string_view text, const std::string& file) {
    if (text.size() > most_toml_bytes) {
        throw InputError("the file holds " + std::to_string(text.size()) + " bytes",
                         "write a TOML file of at most " + std::to_string(most_toml_bytes))
            .at(file, 1);
    }
    NestingScan(text, file).run();
}

} // namespace edgeproof::io
