// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/scene/route/rows.hpp"

#include "edgeproof/precision/error.hpp"

#include <algorithm>

namespace edgeproof::scene {
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
