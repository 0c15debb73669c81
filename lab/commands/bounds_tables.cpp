// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/commands/bounds_tables.hpp"

#include "edgeproof/precision/rounding/text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace edgeproof::cli {
namespace {

using Kind = report::Column::Kind;

using Counts = std::vector<std::pair<const char*, std::size_t validation::CountCell::*>>;

/// Adds two columns that name a cell, and one for each of the counts; a row for each cell with
/// values, or for all cells if the kind has them all; and a row for the total.
void add_counts(report::Table& t, const validation::CountKind& kind,
                const std::array<const char*, 2>& names, const Counts& counts,
                const validation::CountCells& cells, const validation::CountCell& total) {
    t.columns = {{names[0], Kind::text}, {names[1], Kind::text}};
    for (const auto& [name, member] : counts) {
        t.columns.push_back({name, Kind::count});
    }
    const auto add = [&](std::string_view row, std::string_view column,
                         const validation::CountCell& c) {
        t.rows.push_back({std::string(row), std::string(column)});
        for (const auto& [name, member] : counts) {
            t.rows.back().push_back(std::to_string(c.*member));
        }
    };
    for (const auto& [number, c] : cells) {
        if (c.values > 0 || kind.all_cells) {
            add(kind.rows.at(number / kind.columns.size()),
                kind.columns.at(number % kind.columns.size()), c);
        }
    }
    add("all", "all", total);
}

} // namespace

report::Table count_table(const validation::CountOptions& options,
                          const validation::CountResult<validation::CountFinding>& result) {
    using Cell = validation::CountCell;
    report::Table t;
    t.title = std::to_string(result.total.values) + " values at " + std::to_string(options.digits) +
              " digits, seed " + std::to_string(options.seed);
    t.notes = {
        "excluded: the enclosure leaves out the value that the routes in Real give at twice "
        "the digits",
        "wrong: a printed digit is not that of a second enclosure at twice the digits, or of "
        "the value in Real",
        "wide: the enclosure is wider than 10 units of the last digit asked",
        "undecided: no enclosure, or no second value, within the budgets"};
    add_counts(t, validation::enclosure_count(), {"profile", "regime"},
               {{"values", &Cell::values},
                {"excluded", &Cell::excluded},
                {"wrong", &Cell::wrong},
                {"wide", &Cell::wide},
                {"undecided", &Cell::undecided}},
               result.cells, result.total);
    return t;
}

report::Table binary64_table(const validation::CountResult<std::string>& count) {
    using Cell = validation::CountCell;
    report::Table t;
    t.title = "Values in double words, in " + std::to_string(count.contacts) + " contacts";
    t.notes = {"undecided: left to balls, as the rounding is open",
               "wrong: not the binary64 that an enclosure of 320 bits or more rounds to"};
    add_counts(
        t, validation::binary64_count(), {"value", "place"},
        {{"values", &Cell::values}, {"undecided", &Cell::undecided}, {"wrong", &Cell::wrong}},
        count.cells, count.total);
    return t;
}

std::string finding_text(const validation::CountFinding& f) {
    return std::string(f.failed ? "FAILED" : "undecided") + ": " + f.asked + " (contact " +
           std::to_string(f.contact) + ", value " + std::to_string(f.value) + "): " + f.what +
           "\n  printed " + f.text + "\n  second  " + f.second + "\n" + f.scene;
}

std::string aligned_text(const report::Table& table) {
    std::string text = table.title + "\n";
    for (const std::string& note : table.notes) {
        text += "  " + note + "\n";
    }
    return text + "\n" + report::aligned_lines(table, 0, true);
}

} // namespace edgeproof::cli
