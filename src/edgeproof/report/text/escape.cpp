// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/report/text/escape.hpp"

#include "edgeproof/precision/message.hpp"

#include <algorithm>
#include <array>

namespace edgeproof::report {
namespace {

/// True for -1/3, +2.5e-7: these are safe in a spreadsheet, and scripts read them as numbers.
bool is_number(std::string_view text) {
    const std::size_t digits = text.find_first_of("0123456789");
    return digits <= 1 && text.find_first_not_of("+-.0123456789eE/") == std::string_view::npos;
}

/// Nearly all cells consist of these characters and are not changed.
bool is_plain(char c) {
    static constexpr auto plain = [] {
        std::array<bool, 256> known{};
        for (unsigned i = ' '; i <= '~'; ++i) {
            known.at(i) = i != ',' && i != '"';
        }
        return known;
    }();
    return plain[static_cast<unsigned char>(c)];
}

std::string in_quotes(std::string_view text) {
    std::string out = "\"";
    for (const char c : text) {
        out += c;
        if (c == '"') {
            out += c;
        }
    }
    return out + "\"";
}

} // namespace

void add_csv_cell(std::string& line, std::string_view text) {
    // A line that begins with # is a note, and blanks at the ends of a cell are ignored.
    const bool read_otherwise =
        !text.empty() && (text.front() == '#' || text.front() == ' ' || text.back() == ' ');
    if (!read_otherwise && std::all_of(text.begin(), text.end(), is_plain)) {
        line += text;
        return;
    }
    const bool quoted = read_otherwise || text.find_first_of(",\"\r\n") != std::string_view::npos;
    const std::string in_a_line = printable(text);
    line += quoted ? in_quotes(in_a_line) : in_a_line;
}

std::string csv_cell(std::string_view text) {
    std::string cell;
    add_csv_cell(cell, text);
    return cell;
}

std::string csv_text_cell(std::string_view text) {
    constexpr std::string_view begins_a_formula = "=+-@\t\r";
    const bool formula = !text.empty() &&
                         begins_a_formula.find(text.front()) != std::string_view::npos &&
                         !is_number(text);
    return csv_cell(formula ? "'" + std::string(text) : std::string(text));
}

std::string markdown_text(std::string_view text) {
    // An interval, [0.1, 0.2], needs no escapes: a bracket makes a link only if "(", "[" or ":"
    // follows.
    const bool link = text.find("](") != std::string_view::npos ||
                      text.find("][") != std::string_view::npos ||
                      text.find("]:") != std::string_view::npos;
    const std::string_view marks = link ? "\\|`[]" : "\\|`";
    std::string out;
    for (const char c : printable(text)) {
        if (c == '<') {
            out += "&lt;";
        } else if (c == '&') {
            out += "&amp;";
        } else {
            if (marks.find(c) != std::string_view::npos) {
                out += '\\';
            }
            out += c;
        }
    }
    return out;
}

std::string markdown_code(std::string_view text) {
    std::string out = "`";
    for (const char c : printable(text)) {
        out += c == '|' ? "\\|" : c == '`' ? "'" : std::string(1, c);
    }
    return out + "`";
}

std::string latex_text(std::string_view text) {
    std::string out;
    for (const char c : printable(text)) {
        switch (c) {
        case '\\':
            out += "\\textbackslash{}";
            break;
        case '~':
            out += "\\textasciitilde{}";
            break;
        case '^':
            out += "\\textasciicircum{}";
            break;
        case '_':
        case '%':
        case '&':
        case '#':
        case '$':
        case '{':
        case '}':
            out += '\\';
            out += c;
            break;
        default:
            out += c;
        }
    }
    return out;
}

std::string xml_text(std::string_view text) {
    std::string out;
    for (const char c : printable(text)) {
        switch (c) {
        case '&':
            out += "&amp;";
            break;
        case '<':
            out += "&lt;";
            break;
        case '>':
            out += "&gt;";
            break;
        case '"':
            out += "&quot;";
            break;
        default:
            out += c;
        }
    }
    return out;
}

} // namespace edgeproof::report
