// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/scene/design/design_text.hpp"

#include <algorithm>
#include <cctype>

namespace edgeproof::scene {
namespace {

std::string_view trimmed(std::string_view s) {
    const std::size_t from = s.find_first_not_of(" \t\r");
    if (from == std::string_view::npos) {
        return {};
    }
    return s.substr(from, s.find_last_not_of(" \t\r") - from + 1);
}

/// Returns "profile" for the header "[profile]"; nothing for other lines.
std::string header_of(std::string_view line) {
    const std::string_view s = trimmed(line);
    const std::size_t end = s.find(']');
    if (s.empty() || s.front() != '[' || end == std::string_view::npos) {
        return {};
    }
    return std::string(trimmed(s.substr(1, end - 1)));
}

void for_lines(std::string_view text, const std::function<void(std::string_view)>& f) {
    for (std::size_t at = 0; at <= text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        f(text.substr(at, end - at));
        at = end + 1;
    }
}

bool is_name_character(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

/// Replaces the names in each quoted part of a line; comments are not changed.
std::string with_quoted_replaced(std::string_view line,
                                 const std::map<std::string, std::string>& values) {
    std::string out;
    for (std::size_t at = 0; at < line.size();) {
        const char c = line[at];
        if (c == '#') {
            return out + std::string(line.substr(at));
        }
        if (c != '"') {
            out += c;
            ++at;
            continue;
        }
        const std::size_t end = std::min(line.find('"', at + 1), line.size());
        out += '"' + with_names_replaced(line.substr(at + 1, end - at - 1), values);
        out += end < line.size() ? "\"" : "";
        at = end + 1;
    }
    return out;
}

} // namespace

std::string without_sections(std::string_view text, const std::vector<std::string>& names) {
    std::string out;
    bool left_out = false;
    for_lines(text, [&](std::string_view line) {
        const std::string header = header_of(line);
        if (!header.empty() && line.find('=') == std::string_view::npos) {
            left_out = std::find(names.begin(), names.end(), header) != names.end();
        }
        out += (left_out ? std::string() : std::string(line)) + '\n';
    });
    out.pop_back();
    return out;
}

std::string with_names_replaced(std::string_view formula,
                                const std::map<std::string, std::string>& values) {
    std::string out;
    for (std::size_t at = 0; at < formula.size();) {
        if (!is_name_character(formula[at])) {
            out += formula[at++];
            continue;
        }
        std::size_t end = at;
        while (end < formula.size() && is_name_character(formula[end])) {
            ++end;
        }
        const std::string name(formula.substr(at, end - at));
        const auto it = values.find(name);
        out += it == values.end() ? name : "(" + it->second + ")";
        at = end;
    }
    return out;
}

std::string with_values(std::string_view text, const std::map<std::string, std::string>& values) {
    std::string out;
    std::string section;
    for_lines(text, [&](std::string_view line) {
        const std::string header = header_of(line);
        if (!header.empty() && line.find('=') == std::string_view::npos) {
            section = header;
        }
        const bool numbers = section == "profile" || section == "load" || section == "shear";
        const std::size_t equals = line.find('=');
        const std::string key(equals == std::string_view::npos ? std::string_view()
                                                               : trimmed(line.substr(0, equals)));
        const auto it = values.find(key);
        const std::string_view value =
            equals == std::string_view::npos ? line : trimmed(line.substr(equals + 1));
        if (numbers && it != values.end() && !value.empty() && value.front() == '{') {
            out += key + " = \"" + it->second + "\"\n";
            return;
        }
        const bool kind = key == "kind" || key == "path";
        out += (numbers && !kind ? with_quoted_replaced(line, values) : std::string(line)) + '\n';
    });
    out.pop_back();
    return out;
}

} // namespace edgeproof::scene
