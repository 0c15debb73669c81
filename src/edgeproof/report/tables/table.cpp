// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/report/tables/table.hpp"

#include "edgeproof/precision/error.hpp"
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

} // namespace

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

Table columns_kept(const Table& table, const std::function<bool(const Column&)>& kept) {
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
        return latex_tables(table, layout.notes);
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
        require(std::ranges::find(known, name) != known.end(),
                "--columns: there is no column '" + name + "'", one_of(name, known));
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

} // namespace edgeproof::report
