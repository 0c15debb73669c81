// SPDX-License-Identifier: BSD-3-Clause
#include "tests/support/namespaces.hpp"
#pragma once
#include <array>
#include <cctype>
#include <string>
#include <string_view>
#include <vector>

namespace edgeproof::test {

/// Returns an empty text if every element of the markup is closed in its order, attributes are
/// quoted and & begins a character reference; else the error. `html`: elements without an end tag
/// are allowed, and the content of script and style is not checked.
inline std::string well_formed(std::string_view text, bool html = false) {
    static constexpr std::array empty_elements{"meta", "link", "input", "br", "hr", "img"};
    std::vector<std::string> open;
    std::size_t at = 0;
    const auto here = [&] { return " near: " + std::string(text.substr(at, 60)); };
    while (at < text.size()) {
        if (text[at] == '&') {
            const std::size_t end = text.find(';', at);
            if (end == std::string_view::npos || end - at > 10) {
                return "a bare &" + here();
            }
            at = end + 1;
            continue;
        }
        if (text[at] == '>') {
            return "a bare >" + here();
        }
        if (text[at] != '<') {
            ++at;
            continue;
        }
        if (text.substr(at, 2) == "<!" || text.substr(at, 2) == "<?") {
            at = text.find('>', at) + 1;
            continue;
        }
        const bool closing = text.substr(at, 2) == "</";
        std::size_t name_end = at + (closing ? 2 : 1);
        const std::size_t name_begin = name_end;
        while (name_end < text.size() && (std::isalnum(static_cast<unsigned char>(text[name_end]))))
            ++name_end;
        const std::string name(text.substr(name_begin, name_end - name_begin));
        if (name.empty()) {
            return "a bare <" + here();
        }
        std::size_t end = name_end;
        char quote = 0;
        for (; end < text.size() && (quote != 0 || text[end] != '>'); ++end) {
            if (quote != 0) {
                quote = text[end] == quote ? '\0' : quote;
            } else if (text[end] == '"' || text[end] == '\'') {
                quote = text[end];
            } else if (text[end] == '<') {
                return "a tag within a tag" + here();
            } else if (text[end] == '=' && text[end + 1] != '"' && text[end + 1] != '\'' &&
                       text[end + 1] != ' ') {
                return "an attribute without quotes" + here();
            }
        }
        if (end >= text.size()) {
            return "a tag that does not end" + here();
        }
        const bool itself = text[end - 1] == '/';
        if (closing) {
            if (open.empty() || open.back() != name) {
                return "</" + name + "> closes " + (open.empty() ? "nothing" : open.back()) +
                       here();
            }
            open.pop_back();
        } else if (!itself) {
            bool empty = false;
            for (const char* known : empty_elements) {
                empty = empty || (html && name == known);
            }
            if (!empty) {
                open.push_back(name);
            }
        }
        at = end + 1;
        if (html && !closing && (name == "script" || name == "style")) {
            at = text.find("</" + name, at);
        }
    }
    return open.empty() ? "" : "not closed: " + open.back();
}

} // namespace edgeproof::test
