// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/scene/route/row.hpp"

#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <utility>

namespace edgeproof::scene {

std::vector<Row> extent_rows(const AskedValue& asked, BoundedValue first_exit,
                             BoundedValue exit_fraction, BoundedValue measure,
                             BoundedValue measure_fraction, std::vector<BoundedValue> crossings,
                             bool leaves) {
    std::vector<Row> rows;
    const auto add = [&](Quantity quantity, BoundedValue value) -> Row& {
        rows.push_back({asked, std::move(value)});
        rows.back().asked.quantity = quantity;
        return rows.back();
    };
    add(Quantity::extent, std::move(first_exit)).reached = leaves;
    add(Quantity::extent_fraction, std::move(exit_fraction)).reached = leaves;
    add(Quantity::measure, std::move(measure));
    add(Quantity::measure_fraction, std::move(measure_fraction));
    for (std::size_t j = 0; j < crossings.size(); ++j) {
        add(Quantity::crossing, std::move(crossings[j])).asked.j = j;
    }
    return rows;
}

const Row* RowsAt::find(Quantity quantity, std::size_t k, std::size_t j) const {
    const auto found = std::find_if(begin(), end(), [&](const Row& row) {
        return row.asked.quantity == quantity && row.asked.k == k && row.asked.j == j;
    });
    return found == end() ? nullptr : &*found;
}

const Row& RowsAt::row(Quantity quantity, std::size_t k) const {
    if (const Row* found = find(quantity, k)) {
        return *found;
    }
    throw Error("a " + std::string(row_of(quantity).name) + " was not computed");
}

const BoundedValue& RowsAt::at(Quantity quantity, std::size_t k) const {
    if (const auto& value = row(quantity, k).value) {
        return *value;
    }
    throw Error("a " + std::string(row_of(quantity).name) + " was not found");
}

} // namespace edgeproof::scene
