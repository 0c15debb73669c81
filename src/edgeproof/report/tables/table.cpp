// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/report/tables/table.hpp"

#include "edgeproof/precision/message.hpp"
#include "edgeproof/report/text/escape.hpp"
#include "edgeproof/report/text/program_line.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

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
    return out;
}

std::string csv(const Table& table) {
    std::string out = heading(table, "# ");
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
    return out;
}

Json json_cell(const Column& column, const std::string& cell) {
    if (cell.empty()) {
        return nullptr;
    }
    return column.kind == Column::Kind::count ? Json(std::stoll(cell)) : Json(cell);
}

std::string json(const Table& table) {
    Json root = Json::object();
    root["title"] = table.title;
    for (const Fact& fact : table.facts) {
        root[fact.key] =
            fact.bound.empty()
                ? Json(fact.value)
                : Json{{"value", fact.value}, {"bound", fact.bound}, {"route", fact.route}};
    }
    root["notes"] = table.notes;
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

/// Distributes the columns over tables no wider than `most` (0: one table).
std::vector<std::vector<std::size_t>> columns_that_fit(const std::vector<std::size_t>& width,
                                                       std::size_t most) {
    constexpr std::size_t repeated = 2; // the columns that identify a row
    constexpr std::size_t rule = 3;     // " | "
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

std::string markdown(const Table& table, std::size_t most) {
    std::string out;
    if (!table.title.empty()) {
        out += "# " + markdown_text(table.title) + "\n\n";
    }
    for (const Fact& fact : table.facts) {
        out += "- " + markdown_text(fact_text(fact)) + "\n";
    }
    for (const std::string& note : table.notes) {
        out += "- " + markdown_text(note) + "\n";
    }
    out += "\n";
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
    for (const std::vector<std::size_t>& columns : columns_that_fit(width, most)) {
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

std::string latex(const Table& table) {
    std::string out = heading(table, "% ") + "% needs the package booktabs\n\\begin{tabular}{";
    for (const Column& column : table.columns) {
        out += column.kind == Column::Kind::text ? "l" : "r";
    }
    out += "}\n\\toprule\n";
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        out += (i == 0 ? "" : " & ") + latex_text(table.columns[i].name);
    }
    out += " \\\\\n\\midrule\n";
    for (const auto& row : table.rows) {
        for (std::size_t i = 0; i < row.size(); ++i) {
            out += (i == 0 ? "" : " & ") + (table.columns[i].kind == Column::Kind::text
                                                ? latex_text(row[i])
                                                : latex_number(row[i]));
        }
        out += " \\\\\n";
    }
    return out + "\\bottomrule\n\\end{tabular}\n";
}

} // namespace

std::optional<TableFormat> table_format(std::string_view name) {
    return name == "csv"    ? std::optional(TableFormat::csv)
           : name == "json" ? std::optional(TableFormat::json)
           : name == "md"   ? std::optional(TableFormat::markdown)
           : name == "tex"  ? std::optional(TableFormat::latex)
                            : std::nullopt;
}

std::string write_table(const Table& given, TableFormat format, std::size_t width) {
    Table table = given;
    const bool named = std::any_of(table.facts.begin(), table.facts.end(),
                                   [](const Fact& fact) { return fact.key == "program"; });
    if (!named) {
        table.facts.push_back({"program", program_line()});
    }
    switch (format) {
    case TableFormat::json:
        return json(table);
    case TableFormat::markdown:
        return markdown(table, width);
    case TableFormat::latex:
        return latex(table);
    case TableFormat::csv:
        break;
    }
    return csv(table);
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
