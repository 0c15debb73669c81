// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/report/text/html_markup.hpp"

#include "edgeproof/precision/error.hpp"

namespace edgeproof::report {
namespace {

/// Returns the length of the well-formed UTF-8 sequence at the start of `s`; 0 if there is none.
std::size_t sequence_length(std::string_view s) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(s[i]); };
    const unsigned char head = byte(0);
    const std::size_t n = head < 0x80   ? 1
                          : head < 0xC2 ? 0
                          : head < 0xE0 ? 2
                          : head < 0xF0 ? 3
                          : head < 0xF5 ? 4
                                        : 0;
    if (n == 0 || n > s.size()) {
        return 0;
    }
    for (std::size_t i = 1; i < n; ++i) {
        if ((byte(i) & 0xC0U) != 0x80U) {
            return 0;
        }
    }
    const bool overlong = (head == 0xE0 && byte(1) < 0xA0) || (head == 0xF0 && byte(1) < 0x90);
    const bool surrogate = head == 0xED && byte(1) >= 0xA0;
    const bool beyond = head == 0xF4 && byte(1) >= 0x90;
    return overlong || surrogate || beyond ? 0 : n;
}

} // namespace

std::string escape_html(std::string_view text) {
    std::string out;
    out.reserve(text.size());
    while (!text.empty()) {
        const std::size_t n = sequence_length(text);
        const char c = text.front();
        if (n == 0) {
            out += "\xEF\xBF\xBD";
        } else if (n > 1) {
            out += text.substr(0, n);
        } else if (c == '&') {
            out += "&amp;";
        } else if (c == '<') {
            out += "&lt;";
        } else if (c == '>') {
            out += "&gt;";
        } else if (c == '"') {
            out += "&quot;";
        } else if (c == '\'') {
            out += "&#39;";
        } else if ((static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t') || c == 0x7F) {
            out += ' ';
        } else {
            out += c;
        }
        text.remove_prefix(n == 0 ? 1 : n);
    }
    return out;
}

std::string fill_template(std::string_view text,
                          const std::map<std::string, std::string, std::less<>>& values) {
    std::string out;
    while (true) {
        const std::size_t open = text.find("{{");
        out += text.substr(0, open);
        if (open == std::string_view::npos) {
            return out;
        }
        const std::size_t close = text.find("}}", open);
        if (close == std::string_view::npos) {
            throw Error("a template of the report has {{ without }}");
        }
        const std::string_view name = text.substr(open + 2, close - open - 2);
        const auto value = values.find(name);
        if (value == values.end()) {
            throw Error("a template of the report asks for '" + std::string(name) +
                        "', which nothing supplies");
        }
        out += value->second;
        text.remove_prefix(close + 2);
    }
}

} // namespace edgeproof::report
