// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/report/tables/table.hpp"

#include "edgeproof/precision/message.hpp"
#include "edgeproof/report/text/escape.hpp"

#include <algorithm>
#include <array>

namespace edgeproof::report {
namespace {

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

} // namespace edgeproof::report
