// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/scene/route/value_route.hpp"

#include "edgeproof/precision/error.hpp"

namespace edgeproof::scene {

ContactValues contact_values(ValueRoute& route, const Scene& scene, const Plan& plan) {
    ContactValues values;
    for (const QuantityRow& row : quantity_rows()) {
        const AskedValue asked{row.quantity};
        const bool peak = row.group == QuantityGroup::peak;
        if ((row.group != QuantityGroup::contact && !peak) || row.at_edge() ||
            lack_of(scene, asked)) {
            continue;
        }
        switch (row.quantity) {
        case Quantity::a:
            values.a = route.value(asked);
            break;
        case Quantity::b:
            values.b = route.value(asked);
            break;
        case Quantity::alpha:
            values.alpha = route.value(asked);
            break;
        default:
            if (peak ? !plan.peak : !plan.resultants) {
                break;
            }
            if (row.quantity == Quantity::P) {
                values.force = route.value(asked);
            } else if (row.quantity == Quantity::M) {
                values.moment = route.value(asked);
            } else {
                values.others.emplace_back(row.quantity, route.value(asked));
            }
        }
    }
    return values;
}

std::optional<BoundedValue> cycle_energy_of(ValueRoute& route, const Scene& scene,
                                            const Plan& plan) {
    if (!plan.slip || !has_cycle_energy(scene)) {
        return {};
    }
    try {
        return route.value({Quantity::cycle_energy});
    } catch (const Error&) { // the stick zone reports errors of the scene
        return {};
    }
}

} // namespace edgeproof::scene
