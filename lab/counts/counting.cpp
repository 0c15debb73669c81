// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/counts/counting.hpp"

namespace edgeproof::validation {

void add_counts(report::Table& table, const CountNames& names,
                const std::vector<std::pair<const char*, std::size_t CountCell::*>>& counts,
                const CountCells& cells, const CountCell& total) {
    using Kind = report::Column::Kind;
    table.columns = {{std::string(names.row), Kind::text}, {std::string(names.column), Kind::text}};
    for (const auto& [name, member] : counts) {
        table.columns.push_back({name, Kind::count});
    }
    const auto add = [&](std::string_view row, std::string_view column, const CountCell& cell) {
        table.rows.push_back({std::string(row), std::string(column)});
        for (const auto& [name, member] : counts) {
            table.rows.back().push_back(std::to_string(cell.*member));
        }
    };
    for (const auto& [number, cell] : cells) {
        add(names.rows.at(number / names.columns.size()),
            names.columns.at(number % names.columns.size()), cell);
    }
    add("all", "all", total);
}

} // namespace edgeproof::validation
