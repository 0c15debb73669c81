// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/report/tables/table.hpp"

#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/message.hpp"
#include "edgeproof/report/text/escape.hpp"
#include "edgeproof/report/text/program_line.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>

namespace edgeproof::report {
namespace {

using Json = nlohmann::ordered_json;

std::string fact_text(const Fact& fact) {
    std::string text = fact.key + ": " + fact.value;
    if (!fact.bound.empty()) {
        text += " +- " + fact.bound + " (" + fact.route + ")";
    }
    return text;
}

std::string heading(const Table& table, const std::string& mark) {
    std::string out;
    const auto line = [&](const std::string& text) { out += mark + printable(text) + "\n"; };
    if (!table.title.empty()) {
        line(table.title);
    }
    for (const Fact& fact : table.facts) {
        line(fact_text(fact));
    }
    for (const std::string& note : table.notes) {
        line(note);
    }
    for (const std::string& remark : table.remarks) {
        line(remark);
    }
    return out;
}

std::string csv(const Table& table, bool notes) {
    const std::string about = notes ? heading(table, "# ") : "";
    std::string out = table.notes_first ? about : "";
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        out += (i == 0 ? "" : ",") + csv_cell(table.columns[i].name);
    }
    out += "\n";
    for (const auto& row : table.rows) {
        for (std::size_t i = 0; i < row.size(); ++i) {
            const Column& column = table.columns[i];
            const bool text = column.kind == Column::Kind::text && !column.exact;
            out += (i == 0 ? "" : ",") + (text ? csv_text_cell(row[i]) : csv_cell(row[i]));
        }
        out += "\n";
    }
    return table.notes_first ? out : out + about;
}

Json json_cell(const Column& column, const std::string& cell) {
    if (cell.empty()) {
        return nullptr;
    }
    return column.kind == Column::Kind::count ? Json(std::stoll(cell)) : Json(cell);
}

std::string json(const Table& table, bool notes) {
    Json root = Json::object();
    if (notes) {
        root["title"] = table.title;
        for (const Fact& fact : table.facts) {
            root[fact.key] =
                fact.bound.empty()
                    ? Json(fact.value)
                    : Json{{"value", fact.value}, {"bound", fact.bound}, {"route", fact.route}};
        }
        root["notes"] = table.notes;
        for (const std::string& remark : table.remarks) {
            root["notes"].push_back(remark);
        }
    }
    Json rows = Json::array();
    for (const auto& row : table.rows) {
        Json object = Json::object();
        for (std::size_t i = 0; i < row.size(); ++i) {
            object[table.columns[i].name] = json_cell(table.columns[i], row[i]);
        }
        rows.push_back(std::move(object));
    }
    root["rows"] = std::move(rows);
    return root.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

constexpr std::size_t separator_width = 3; // " | "

/// Distributes the columns over tables no wider than `most` (0: one table).
std::vector<std::vector<std::size_t>> columns_that_fit(const std::vector<std::size_t>& width,
                                                       std::size_t most) {
    constexpr std::size_t repeated = 2; // the columns that identify a row
    constexpr std::size_t rule = separator_width;
    std::vector<std::vector<std::size_t>> tables(1);
    std::size_t used = 1;
    for (std::size_t i = 0; i < width.size(); ++i) {
        if (most != 0 && used + width[i] + rule > most && tables.back().size() > repeated) {
            tables.push_back({0, 1});
            used = 1 + width[0] + width[1] + 2 * rule;
        }
        tables.back().push_back(i);
        used += width[i] + rule;
    }
    return tables;
}

std::string markdown_heading(const Table& table) {
    std::string out;
    if (!table.title.empty()) {
        out += "# " + markdown_text(table.title) + "\n\n";
    }
    for (const Fact& fact : table.facts) {
        out += "- " + markdown_text(fact_text(fact)) + "\n";
    }
    for (const auto* list : {&table.notes, &table.remarks}) {
        for (const std::string& note : *list) {
            out += "- " + markdown_text(note) + "\n";
        }
    }
    return out + "\n";
}

std::string markdown(const Table& table, const TableLayout& layout) {
    std::string out = layout.notes ? markdown_heading(table) : "";
    std::vector<std::vector<std::string>> cells(1);
    for (const Column& column : table.columns) {
        cells[0].push_back(markdown_text(column.name));
    }
    for (const auto& row : table.rows) {
        cells.emplace_back();
        for (const std::string& cell : row) {
            cells.back().push_back(markdown_text(cell));
        }
    }
    std::vector<std::size_t> width(table.columns.size(), 3);
    for (const auto& row : cells) {
        for (std::size_t i = 0; i < row.size(); ++i) {
            width[i] = std::max(width[i], text_width(row[i]));
        }
    }
    const auto is_text = [&](std::size_t i) { return table.columns[i].kind == Column::Kind::text; };
    bool first = true;
    for (const std::vector<std::size_t>& columns : columns_that_fit(width, layout.width)) {
        const auto line = [&](const std::vector<std::string>& row) {
            out += "|";
            for (const std::size_t i : columns) {
                const std::string blanks(width[i] - text_width(row[i]), ' ');
                out += " " + (is_text(i) ? row[i] + blanks : blanks + row[i]) + " |";
            }
            out += "\n";
        };
        out += first ? "" : "\n";
        first = false;
        line(cells[0]);
        out += "|";
        for (const std::size_t i : columns) {
            out += is_text(i) ? " " + std::string(width[i], '-') + " |"
                              : " " + std::string(width[i] - 1, '-') + ": |";
        }
        out += "\n";
        for (std::size_t i = 1; i < cells.size(); ++i) {
            line(cells[i]);
        }
    }
    return out;
}

/// Returns 1.3e-52 as $1.3\times 10^{-52}$; other text is not changed.
std::string latex_number(const std::string& text) {
    if (text.empty()) {
        return text;
    }
    const std::size_t e = text.find('e');
    const bool number = text.find_first_not_of("+-.0123456789e") == std::string::npos;
    if (!number) {
        return latex_text(text);
    }
    if (e == std::string::npos) {
        return "$" + text + "$";
    }
    const std::string power = std::to_string(std::stol(text.substr(e + 1)));
    return "$" + text.substr(0, e) + "\\times 10^{" + power + "}$";
}

// Lengths in LaTeX at 10 pt, in pt. Digits and most letters of Computer Modern are 5 wide; a
// column is surrounded by 2 \tabcolsep = 12.
constexpr std::size_t latex_letter = 5;
constexpr std::size_t latex_gap = 12;
constexpr std::size_t latex_most = 440;     // A4 with margins of 25 mm has 455; the rest is reserve
constexpr std::size_t latex_half = 190;     // of two columns that fit next to a short one
constexpr std::size_t latex_most_rows = 40; // of a table that cannot be divided between pages

/// The width of a cell: in numbers, "\times 10^{-16}" takes the place of e-16.
std::size_t latex_width(const Column& column, const std::string& text) {
    const std::size_t exponent =
        column.kind != Column::Kind::text && text.find('e') != std::string::npos ? 5 : 0;
    return (text_width(text) + exponent) * latex_letter;
}

/// The columns of a LaTeX table, with their widths.
struct LatexColumns {
    std::vector<std::size_t> width;
    std::vector<bool> broken; ///< the cells are paragraphs of this width

    explicit LatexColumns(const Table& table) {
        for (std::size_t i = 0; i < table.columns.size(); ++i) {
            std::size_t most = text_width(table.columns[i].name) * latex_letter;
            for (const auto& row : table.rows) {
                most = std::max(most, latex_width(table.columns[i], row[i]));
            }
            // Each part repeats the first two columns, and must have space for one more.
            const std::size_t used = i < 2 ? 0 : width[0] + width[1] + 3 * latex_gap;
            const std::size_t limit =
                i < 2 ? latex_half
                      : std::max(latex_most - std::min(used, latex_most), latex_letter * 8);
            broken.push_back(most > limit);
            width.push_back(std::min(most, limit));
        }
    }
};

/// A number that LaTeX may break after every tenth character.
std::string breakable_number(const std::string& text) {
    constexpr std::size_t group = 10;
    const std::size_t e = text.find('e');
    const std::size_t end = std::min(e, text.size());
    std::string out;
    for (std::size_t at = 0; at < end; at += group) {
        const std::string part = text.substr(at, std::min(group, end - at));
        const bool last = at + group >= end;
        out += (at == 0 ? "" : "\\allowbreak") + (last && e != std::string::npos
                                                      ? latex_number(part + text.substr(e))
                                                      : latex_number(part));
    }
    return out;
}

std::string latex_cell(const Column& column, const std::string& text, bool broken) {
    return column.kind == Column::Kind::text ? latex_text(text)
           : broken                          ? breakable_number(text)
                                             : latex_number(text);
}

/// The table with these columns. A long one is divided between pages.
std::string latex_part(const Table& table, const LatexColumns& all,
                       const std::vector<std::size_t>& columns) {
    const bool divided = table.rows.size() > latex_most_rows;
    const std::string environment = divided ? "longtable" : "tabular";
    std::string out = "\\begin{" + environment + "}{";
    for (const std::size_t i : columns) {
        out += all.broken[i] ? "p{" + std::to_string(all.width[i]) + "pt}"
               : table.columns[i].kind == Column::Kind::text ? "l"
                                                             : "r";
    }
    out += "}\n\\toprule\n";
    const auto line = [&](const auto& cell) {
        for (const std::size_t i : columns) {
            out += (i == columns.front() ? "" : " & ") + cell(i);
        }
        out += " \\\\\n";
    };
    line([&](std::size_t i) { return latex_text(table.columns[i].name); });
    out += std::string("\\midrule\n") + (divided ? "\\endhead\n\\bottomrule\n\\endfoot\n" : "");
    for (const auto& row : table.rows) {
        line([&](std::size_t i) { return latex_cell(table.columns[i], row[i], all.broken[i]); });
    }
    return out + (divided ? "" : "\\bottomrule\n") + "\\end{" + environment + "}\n";
}

std::string latex(const Table& table, bool notes) {
    std::string out = notes ? heading(table, "% ") : "";
    out += "% needs the packages booktabs and longtable; at 10 pt at most 16 cm wide\n";
    const LatexColumns all(table);
    std::vector<std::size_t> width;
    for (const std::size_t w : all.width) {
        width.push_back(w + latex_gap - separator_width);
    }
    bool first = true;
    for (const auto& columns : columns_that_fit(width, latex_most)) {
        out += (first ? "" : "\n\\bigskip\n") + latex_part(table, all, columns);
        first = false;
    }
    return out;
}

/// Returns the table without the columns of which `kept` is false.
template <class Kept> Table columns_kept(const Table& table, const Kept& kept) {
    Table part = table;
    for (std::size_t i = table.columns.size(); i-- > 0;) {
        if (!kept(table.columns[i])) {
            const auto at = static_cast<std::ptrdiff_t>(i);
            part.columns.erase(part.columns.begin() + at);
            for (auto& row : part.rows) {
                row.erase(row.begin() + at);
            }
        }
    }
    return part;
}

/// Returns the value with its limit and its unit.
std::string with_bound(const std::string& value, const std::string& bound,
                       const std::string& unit) {
    const std::string limit = bound.empty() || bound == "0" ? "" : " +- " + bound;
    return value + limit + (unit.empty() ? "" : " " + unit);
}

std::string in_phrase(const Column& column, const std::string& text) {
    const std::string phrase = column.phrase.empty() ? column.name + " = {}" : column.phrase;
    const std::size_t at = phrase.find("{}");
    return at == std::string::npos ? phrase : phrase.substr(0, at) + text + phrase.substr(at + 2);
}

/// Returns the parts of a row's line: a value, its bound and its route are one part. A missing
/// value is an empty part.
std::vector<std::string> parts_of_line(const Table& table, const std::vector<std::string>& row) {
    std::vector<std::string> parts;
    for (std::size_t i = 0; i < row.size();) {
        const Column& column = table.columns[i];
        const std::string& value = row[i];
        std::string bound;
        std::string route;
        for (++i; i < row.size() && table.columns[i].role != Column::Role::value; ++i) {
            (table.columns[i].role == Column::Role::bound ? bound : route) = row[i];
        }
        if (value.empty()) {
            parts.emplace_back();
            continue;
        }
        const bool noted = route.find("estimate") != std::string::npos ||
                           route.find("sliding") != std::string::npos;
        parts.push_back(in_phrase(column, with_bound(value, bound, column.unit)) +
                        (noted ? " (" + route + ")" : ""));
    }
    return parts;
}

/// Returns the rows as lines with aligned parts. A line that is wider than the terminal goes on in
/// lines below it, with a margin; all rows are divided at the same parts.
std::string row_lines(const Table& table, std::size_t most) {
    constexpr std::size_t gap = 2;
    constexpr std::size_t margin = 6;
    std::vector<std::vector<std::string>> lines;
    std::vector<std::size_t> widths;
    for (const auto& row : table.rows) {
        lines.push_back(parts_of_line(table, row));
        widths.resize(lines.back().size());
        for (std::size_t i = 0; i < widths.size(); ++i) {
            widths[i] = std::max(widths[i], text_width(lines.back()[i]));
        }
    }
    std::string out;
    for (const auto& parts : lines) {
        std::string line;
        std::size_t used = 0;
        const auto end_line = [&] {
            line.erase(line.find_last_not_of(' ') + 1);
            out += line.empty() ? "" : line + "\n";
            line.assign(margin, ' ');
            used = margin;
        };
        for (std::size_t i = 0; i < parts.size(); ++i) {
            if (widths[i] == 0) {
                continue;
            }
            if (used > margin && used + widths[i] > most) {
                end_line();
            }
            line += parts[i] + std::string(widths[i] - text_width(parts[i]) + gap, ' ');
            used += widths[i] + gap;
        }
        end_line();
    }
    return out;
}

} // namespace

std::optional<TableFormat> table_format(std::string_view name) {
    return name == "csv"    ? std::optional(TableFormat::csv)
           : name == "json" ? std::optional(TableFormat::json)
           : name == "md"   ? std::optional(TableFormat::markdown)
           : name == "tex"  ? std::optional(TableFormat::latex)
                            : std::nullopt;
}

std::string write_table(const Table& given, TableFormat format, const TableLayout& layout) {
    Table table = columns_kept(given, [](const Column& column) {
        return column.shown != Column::Shown::on_terminal_only;
    });
    const bool named = std::any_of(table.facts.begin(), table.facts.end(),
                                   [](const Fact& fact) { return fact.key == "program"; });
    if (!named) {
        table.facts.push_back({"program", program_line()});
    }
    switch (format) {
    case TableFormat::json:
        return json(table, layout.notes);
    case TableFormat::markdown:
        return markdown(table, layout);
    case TableFormat::latex:
        return latex(table, layout.notes);
    case TableFormat::csv:
        break;
    }
    return csv(table, layout.notes);
}

Table with_columns(const Table& table, const std::vector<std::string>& names) {
    std::vector<std::string_view> known;
    for (const Column& column : table.columns) {
        if (column.shown != Column::Shown::on_terminal_only) {
            known.push_back(column.name);
        }
    }
    Table part = table;
    part.columns.clear();
    part.rows.assign(table.rows.size(), {});
    for (const std::string& name : names) {
        if (std::ranges::find(known, name) == known.end()) {
            throw InputError("--columns: there is no column '" + name + "'", one_of(name, known));
        }
        const auto at = static_cast<std::size_t>(
            std::ranges::find(table.columns, name, &Column::name) - table.columns.begin());
        part.columns.push_back(table.columns[at]);
        part.columns.back().shown = Column::Shown::everywhere;
        for (std::size_t j = 0; j < table.rows.size(); ++j) {
            part.rows[j].push_back(table.rows[j][at]);
        }
    }
    return part;
}

std::string short_answer(const Table& given, std::size_t width) {
    constexpr std::array<std::string_view, 6> unsaid{"scene", "digits",  "rounding",
                                                     "units", "program", "tolerance"};
    const Table table = columns_kept(
        given, [](const Column& column) { return column.shown != Column::Shown::not_on_terminal; });
    std::string out;
    const auto line = [&](const std::string& text) { out += printable(text) + "\n"; };
    if (!table.title.empty()) {
        line(table.title);
    }
    if (!table.asked.empty()) {
        line(table.asked);
    }
    const auto text_of = [](const Fact& fact) {
        return with_bound(fact.value, fact.bound, fact.unit) +
               (fact.route.empty() ? "" : " (" + fact.route + ")");
    };
    for (std::size_t i = 0; i < table.facts.size(); ++i) {
        const Fact& fact = table.facts[i];
        if (std::ranges::find(unsaid, fact.key) != unsaid.end()) {
            continue;
        }
        std::string keys = fact.key;
        while (!fact.bound.empty() && i + 1 < table.facts.size() &&
               text_of(table.facts[i + 1]) == text_of(fact)) { // a = b = ...
            keys += " = " + table.facts[++i].key;
        }
        line(keys + " = " + text_of(fact));
    }
    out += printable_lines(row_lines(table, width));
    for (const std::string& remark : table.remarks) {
        line(remark);
    }
    return out;
}

std::string aligned_lines(const Table& table, std::size_t margin, bool rule) {
    std::vector<std::vector<std::string>> lines{{}};
    for (const Column& column : table.columns) {
        lines[0].push_back(column.name);
    }
    lines.insert(lines.end(), table.rows.begin(), table.rows.end());
    std::vector<std::size_t> width(table.columns.size());
    for (const auto& line : lines) {
        for (std::size_t i = 0; i < line.size(); ++i) {
            width[i] = std::max(width[i], line[i].size());
        }
    }
    std::string out;
    for (const auto& line : lines) {
        std::string text(margin, ' ');
        for (std::size_t i = 0; i < line.size(); ++i) {
            const bool left = table.columns[i].kind == Column::Kind::text;
            text += (i == 0 ? "" : "  ") + (left ? fmt::format("{:<{}}", line[i], width[i])
                                                 : fmt::format("{:>{}}", line[i], width[i]));
        }
        text.erase(text.find_last_not_of(' ') + 1);
        const bool ruled = rule && out.empty();
        out += text + '\n' + (ruled ? std::string(text.size(), '-') + '\n' : "");
    }
    return out;
}

std::string html_table(const Table& table, bool grouped) {
    std::string out = "<div class=\"scroll\" tabindex=\"0\"><table class=\"cost\"><thead><tr>";
    const auto add = [&](std::size_t i, const char* tag, const char* scope,
                         const std::string& text) {
        const Column::Kind kind = table.columns[i].kind;
        const bool number = kind == Column::Kind::number || kind == Column::Kind::count;
        out += fmt::format("<{0}{1}{2}>{3}</{0}>", tag, scope, number ? " class=\"number\"" : "",
                           kind == Column::Kind::markup ? text : escape_html(text));
    };
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        add(i, "th", " scope=\"col\"", table.columns[i].name);
    }
    out += "</tr></thead><tbody>\n";
    std::string last;
    for (const auto& row : table.rows) {
        const bool next = grouped && !row[0].empty() && !last.empty() && row[0] != last;
        out += next ? "<tr class=\"next\">" : "<tr>";
        for (std::size_t i = 0; i < row.size(); ++i) {
            add(i, "td", "", row[i]);
        }
        out += "</tr>\n";
        last = row[0].empty() ? last : row[0];
    }
    return out + "</tbody></table></div>\n";
}

} // namespace edgeproof::report
