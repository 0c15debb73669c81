// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/scene/route/value_route.hpp"

#include "edgeproof/precision/error.hpp"

namespace edgeproof::scene {

const Row& ValueRoute::searched(const AskedValue& asked) {
    const QuantityGroup group = row_of(asked.quantity).group;
    auto& rows = searched_[{group, asked.edge, asked.k}];
    if (rows.empty()) {
        rows = group == QuantityGroup::slip ? slip_terms(asked.edge, asked.k)
                                            : extent(asked.edge, asked.k);
    }
    if (const Row* row = RowsAt(rows).find(asked.quantity, asked.k, asked.j)) {
        return *row;
    }
    throw Error("a " + std::string(row_of(asked.quantity).name) + " was not found");
}

} // namespace edgeproof::scene
