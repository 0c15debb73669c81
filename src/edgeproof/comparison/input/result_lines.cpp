// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/comparison/input/result_lines.hpp"
#include "edgeproof/io/foreign_text.hpp"
#include "edgeproof/io/text_file.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/precision/message.hpp"

#include <algorithm>
#include <iterator>
#include <set>

namespace edgeproof::comparison {
namespace {

constexpr std::string_view white = " \t\r\f\v";
constexpr std::size_t lines_looked_at = 400;
constexpr std::pair<char, const char*> separators[] = {
    {'\t', "tabs"}, {';', "semicolons"}, {'|', "bars"}, {',', "commas"}, {' ', "blanks"}};

bool is_comment(std::string_view line) {
    line = trimmed(line, white);
    line.remove_prefix(line.starts_with('"') ? 1 : 0); // a spreadsheet quotes it
    if (line.find_first_not_of("*0123456789+-.eEdD,;| \t") == std::string_view::npos &&
        line.find_first_of("0123456789") != std::string_view::npos) {
        return false; // a row with a number that does not fit into its column, in Fortran
    }
    return std::ranges::any_of(std::array<std::string_view, 5>{"#", "%", "!", "//", "**"},
                               [line](std::string_view mark) { return line.starts_with(mark); });
}

Cell cell_of(std::string_view text) {
    text = trimmed(text, white);
    if (text.size() >= 2 && text.front() == text.back() &&
        (text.front() == '"' || text.front() == '\'')) {
        return {std::string(trimmed(text.substr(1, text.size() - 2), white)), true};
    }
    return {std::string(text), false};
}

/// Finds the separator of `text`, and the shape of its rows.
class ShapeFinder {
public:
    explicit ShapeFinder(ResultText& text) : text_(text) {}

    void find() {
        std::optional<long> most;
        for (const auto& [separator, name] : separators) {
            const auto score = score_of(separator);
            if (score && (!most || *score > *most)) {
                text_.separator = separator;
                most = score;
            }
        }
        if (!most) {
            text_.reject(0, "there is no row of two numbers",
                         "give a table with a column of places x and one of pressures p");
        }
        std::map<std::size_t, std::size_t> sizes;
        std::size_t seen = 0;
        for (const ResultLine& line : text_.lines) {
            const auto cells = text_.cells(line);
            if (!line.comment && seen < 100 && text_.numbers_in(cells) >= 2) {
                ++sizes[cells.size()];
                ++seen;
            }
        }
        if (!sizes.empty()) {
            text_.size =
                std::ranges::max_element(sizes, {}, [](const auto& n) { return n.second; })->first;
        }
        const auto first = std::ranges::find_if(text_.lines, [&](const ResultLine& line) {
            const auto cells = text_.cells(line);
            return !line.comment && text_.numbers_in(cells) >= 2 && cells.size() == text_.size;
        });
        text_.first_row = static_cast<std::size_t>(first - text_.lines.begin());
    }

private:
    /// The numbers minus the other cells, in lines of two numbers or more; nothing without any.
    [[nodiscard]] std::optional<long> score_of(char separator) const {
        std::optional<long> score;
        std::size_t seen = 0;
        for (const ResultLine& line : text_.lines) {
            if (line.comment) {
                continue;
            }
            if (++seen > lines_looked_at) {
                break;
            }
            long numbers = 0;
            long others = 0;
            for (const Cell& cell : split_row(line.text, separator)) {
                const bool number = number_of(cell, separator) || is_nan_or_infinite(cell);
                numbers += number ? 1 : 0;
                others += !number && !cell.text.empty() ? 1 : 0;
            }
            if (numbers >= 2) {
                score = score.value_or(0) + numbers - others;
            }
        }
        return score;
    }

    ResultText& text_;
};

/// Writes the exponent with the letter E: in "1.5-104" Fortran omits it, because the exponent has
/// three digits; gfortran writes a Q for four times the precision, and Mathematica "1.5*^-4".
std::optional<std::string> with_exponent_letter(const std::string& text) {
    std::size_t at = std::string::npos;
    std::size_t size = 0; // of the mark that the letter replaces
    for (const std::string_view mark : {"Q", "q", "*^"}) {
        if (at == std::string::npos && text.find_first_of("eEdD") == std::string::npos) {
            at = text.find(mark);
            size = mark.size();
        }
    }
    if (at == std::string::npos && text.find_first_not_of("+-.0123456789") == std::string::npos) {
        at = text.find_last_of("+-");
        at = text.size() - at == 4 ? at : std::string::npos;
        size = 0;
    }
    if (at == std::string::npos || at == 0) {
        return {};
    }
    std::string out = text;
    out.replace(at, size, "E");
    return io::read_number(out) ? std::optional(out) : std::nullopt;
}

/// Writes the minus sign and the blanks beyond ASCII, which spreadsheets and web pages contain, as
/// '-' and ' '.
std::string with_ascii_marks(std::string_view line) {
    std::string out(line);
    for (const auto& [mark, plain] : {std::pair{"\xE2\x88\x92", "-"}, std::pair{"\xC2\xA0", " "},
                                      std::pair{"\xE2\x80\xAF", " "}}) {
        const std::string_view bytes = mark;
        for (std::size_t at = 0; (at = out.find(bytes, at)) != std::string::npos; ++at) {
            out.replace(at, bytes.size(), plain);
        }
    }
    return out;
}

} // namespace

std::string separator_name(char separator) {
    return std::ranges::find(separators, separator, &std::pair<char, const char*>::first)->second;
}

std::size_t ResultText::numbers_in(const std::vector<Cell>& cells) const {
    return static_cast<std::size_t>(
        std::ranges::count_if(cells, [this](const Cell& cell) { return is_number(cell); }));
}

void ResultText::reject(std::size_t line, const std::string& problem,
                        const std::string& instead) const {
    throw InputError(problem, instead).at(file, line);
}

ResultText result_text(std::string_view text, const std::string& file) {
    ResultText result{file, {}};
    if (io::is_utf16(text)) {
        return result_text(io::utf8_text(std::string(text), file), file);
    }
    if (text.find('\0') != std::string_view::npos) {
        result.reject(0, "the file is not text: it contains a zero byte",
                      "give a table of x and p as text");
    }
    text.remove_prefix(text.starts_with("\xEF\xBB\xBF") ? 3 : 0);
    if (!io::is_utf8(text)) {
        return result_text(io::utf8_from_latin1(text), file);
    }
    std::size_t number = 1;
    for (std::size_t at = 0; at < text.size(); ++number) {
        if (number % 4096 == 0) {
            check_interruption();
        }
        const std::size_t end = std::min(text.find_first_of("\r\n", at), text.size());
        std::string line = with_ascii_marks(text.substr(at, end - at));
        if (!trimmed(line, white).empty()) {
            const bool comment = is_comment(line);
            result.lines.push_back({number, std::move(line), comment});
        }
        at = end + (text.substr(end).starts_with("\r\n") ? 2 : 1);
    }
    if (result.lines.empty()) {
        result.reject(0, "the file is empty", "give a table of places x and pressures p");
    }
    ShapeFinder(result).find();
    return result;
}

std::vector<Cell> split_row(std::string_view line, char separator) {
    std::vector<Cell> cells;
    if (separator == ' ') {
        line = trimmed(line, white);
    }
    std::size_t from = 0;
    char quote = '\0';
    for (std::size_t at = 0; at <= line.size(); ++at) {
        const bool end = at == line.size();
        if (!end && quote != '\0') {
            quote = line[at] == quote ? '\0' : quote;
            continue;
        }
        if (!end && (line[at] == '"' || line[at] == '\'') &&
            trimmed(line.substr(from, at - from), white).empty()) {
            quote = line[at];
            continue;
        }
        if (!end && line[at] != separator && !(separator == ' ' && line[at] == '\t')) {
            continue;
        }
        const std::string_view cell = line.substr(from, at - from);
        if (separator != ' ' || !cell.empty()) {
            cells.push_back(cell_of(cell));
        }
        from = at + 1;
    }
    while (!cells.empty() && cells.back().text.empty()) {
        cells.pop_back();
    }
    return cells;
}

std::optional<std::string> number_of(const Cell& cell, char separator) {
    if (io::read_number(cell.text)) {
        return cell.text;
    }
    if (auto fortran = with_exponent_letter(cell.text)) {
        return fortran;
    }
    return separator != ',' || cell.quoted ? io::with_decimal_point(cell.text) : std::nullopt;
}

namespace {

/// The first mark of a number, if it has one.
struct Mark {
    char mark = '\0';
    bool group = false; ///< it may stand between thousands
    bool plain = false; ///< there is none, and at most three digits, not all 0
};

Mark mark_of(std::string_view text) {
    const std::size_t at = text.find_first_of(".,");
    if (at == std::string_view::npos) {
        const auto digits =
            std::ranges::count_if(text, [](char c) { return c >= '0' && c <= '9'; });
        return {.plain = digits <= 3 && text.find_first_of("123456789") != text.npos};
    }
    std::string_view whole = text.substr(0, at);
    whole.remove_prefix(whole.starts_with('-') || whole.starts_with('+') ? 1 : 0);
    return {text[at], !whole.empty() && whole.size() <= 3 && whole.front() != '0' &&
                          text.size() - at == 4 &&
                          text.find_first_not_of("0123456789", at + 1) == text.npos};
}

} // namespace

std::optional<std::pair<std::size_t, std::size_t>>
ambiguous_mark(const std::vector<std::vector<std::string>>& columns) {
    std::vector<std::vector<Mark>> marks;
    std::set<char> decimal; // the marks that cannot stand between thousands in some number
    for (const auto& column : columns) {
        std::ranges::transform(column, std::back_inserter(marks.emplace_back()), mark_of);
        for (const Mark& m : marks.back()) {
            if (!m.group) {
                decimal.insert(m.mark);
            }
        }
    }
    for (std::size_t k = 0; k < marks.size(); ++k) {
        const bool plain = std::ranges::any_of(marks[k], &Mark::plain);
        for (const char mark : {',', '.'}) {
            const auto found = std::ranges::find_if(
                marks[k], [mark](const Mark& m) { return m.group && m.mark == mark; });
            const bool other = decimal.contains(mark == ',' ? '.' : ',');
            if (found != marks[k].end() && !decimal.contains(mark) &&
                (other || (plain && mark == ','))) {
                return std::pair(k, static_cast<std::size_t>(found - marks[k].begin()));
            }
        }
    }
    return {};
}

std::string shown_cell(std::string_view text) {
    constexpr std::size_t longest = 40;
    return "'" + shortened(printable(text), longest) + "'";
}

bool is_nan_or_infinite(const Cell& cell) {
    using enum io::WrittenNumber::Kind;
    const io::WrittenNumber::Kind kind = io::written_number(cell.text).kind;
    return kind == nan || kind == infinite;
}

} // namespace edgeproof::comparison
