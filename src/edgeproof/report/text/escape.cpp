// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/report/text/escape.hpp"

#include "edgeproof/precision/message.hpp"

#include <boost/locale/utf.hpp>

#include <algorithm>
#include <initializer_list>
#include <utility>

namespace edgeproof::report {
namespace {

/// True for -1/3, +2.5e-7: these are safe in a spreadsheet, and scripts read them as numbers.
bool is_number(std::string_view text) {
    const std::size_t digits = text.find_first_of("0123456789");
    return digits <= 1 && text.find_first_not_of("+-.0123456789eE/") == std::string_view::npos;
}

/// Nearly all cells consist of these characters and are not changed.
bool is_plain(char c) { return c >= ' ' && c <= '~' && c != ',' && c != '"'; }

using Replacements = std::initializer_list<std::pair<char, std::string_view>>;

/// Returns the text with some of its characters replaced.
std::string replaced(std::string_view text, Replacements replacements) {
    std::string out;
    out.reserve(text.size());
    for (const char c : text) {
        const auto* const found =
            std::ranges::find(replacements, c, &Replacements::value_type::first);
        if (found == replacements.end()) {
            out += c;
        } else {
            out += found->second;
        }
    }
    return out;
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
    line += quoted ? '"' + replaced(in_a_line, {{'"', "\"\""}}) + '"' : in_a_line;
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
    const std::string out = replaced(printable(text), {{'<', "&lt;"},
                                                       {'&', "&amp;"},
                                                       {'\\', "\\\\"},
                                                       {'|', "\\|"},
                                                       {'`', "\\`"},
                                                       {'*', "\\*"},
                                                       {'_', "\\_"}});
    return link ? replaced(out, {{'[', "\\["}, {']', "\\]"}}) : out;
}

std::string markdown_code(std::string_view text) {
    return '`' + replaced(printable(text), {{'|', "\\|"}, {'`', "'"}}) + '`';
}

std::string latex_text(std::string_view text) {
    return replaced(printable(text), {{'\\', "\\textbackslash{}"},
                                      {'~', "\\textasciitilde{}"},
                                      {'^', "\\textasciicircum{}"},
                                      {'_', "\\_"},
                                      {'%', "\\%"},
                                      {'&', "\\&"},
                                      {'#', "\\#"},
                                      {'$', "\\$"},
                                      {'<', "$<$"},
                                      {'>', "$>$"},
                                      {'|', "$|$"},
                                      {'{', "\\{"},
                                      {'}', "\\}"}});
}

std::string xml_text(std::string_view text) {
    return replaced(printable(text),
                    {{'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}});
}

std::string escape_html(std::string_view text) {
    namespace utf = boost::locale::utf;
    std::string valid;
    valid.reserve(text.size());
    while (!text.empty()) {
        const auto* next = text.begin();
        const utf::code_point code = utf::utf_traits<char>::decode(next, text.end());
        const bool invalid = code == utf::illegal || code == utf::incomplete;
        const bool control = (code < 0x20 && code != '\n' && code != '\t') || code == 0x7F;
        const std::size_t n = invalid ? 1 : static_cast<std::size_t>(next - text.begin());
        valid += invalid ? "\xEF\xBF\xBD" : control ? " " : text.substr(0, n);
        text.remove_prefix(n);
    }
    return replaced(
        valid, {{'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}, {'\'', "&#39;"}});
}

} // namespace edgeproof::report
