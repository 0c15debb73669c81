// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/scene/route/value_route.hpp"

#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <utility>

namespace edgeproof::scene {
namespace {

Row row_with(const AskedValue& asked, Quantity quantity, std::optional<BoundedValue> value) {
    Row row{asked, std::move(value)};
    row.asked.quantity = quantity;
    return row;
}

} // namespace

std::vector<Row> extent_rows(const AskedValue& asked, const std::array<BoundedValue, 4>& values,
                             const std::vector<BoundedValue>& crossings, bool leaves) {
    std::vector<Row> rows{row_with(asked, Quantity::extent, values[0]),
                          row_with(asked, Quantity::extent_fraction, values[1]),
                          row_with(asked, Quantity::measure, values[2]),
                          row_with(asked, Quantity::measure_fraction, values[3])};
    rows[0].reached = rows[1].reached = leaves;
    for (std::size_t j = 0; j < crossings.size(); ++j) {
        rows.push_back(row_with(asked, Quantity::crossing, crossings[j]));
        rows.back().asked.j = j;
    }
    return rows;
}

std::vector<Row> slip_rows(const AskedValue& asked, BoundedValue size, BoundedValue error) {
    return {row_with(asked, Quantity::slip_terms, std::move(size)),
            row_with(asked, Quantity::slip_rel, std::move(error)),
            row_with(asked, Quantity::slip_load, {})};
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

const Row& ValueRoute::searched(const AskedValue& asked) {
    auto& rows = searched_[{row_of(asked.quantity).group, asked.edge, asked.k}];
    if (rows.empty()) {
        rows = search(asked);
    }
    if (const Row* row = RowsAt(rows).find(asked.quantity, asked.k, asked.j)) {
        return *row;
    }
    throw Error("a " + std::string(row_of(asked.quantity).name) + " was not found");
}

} // namespace edgeproof::scene
