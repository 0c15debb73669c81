// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/scene/scene_values.hpp"

#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <set>

namespace edgeproof::scene {

Scene asking(const Scene& scene, const std::vector<AskedValue>& values, const Digits& digits) {
    Scene s = scene;
    s.ask = Ask{};
    s.ask.edges = {contact::Edge::right, contact::Edge::left};
    s.ask.digits = digits;
    bool shear = false;
    std::size_t orders = 0;
    std::set<std::size_t> numbers_of_terms;
    for (const AskedValue& v : values) {
        const QuantityRow& row = row_of(v.quantity);
        s.ask.quantities.insert(row.group);
        shear = shear || row.of_shear();
        if (v.u) {
            s.ask.u.push_back({*v.u, 0});
        }
        if (v.tolerance) {
            s.ask.tolerance = v.tolerance;
        }
        if (row.index == QuantityRow::Index::order) {
            orders = std::max(orders, v.k + 1);
        } else if (row.index == QuantityRow::Index::terms) {
            numbers_of_terms.insert(v.k);
        }
    }
    if (!shear) {
        s.shear.reset();
    }
    if (orders > 0) {
        numbers_of_terms.insert(orders);
    }
    s.ask.terms.assign(numbers_of_terms.begin(), numbers_of_terms.end());
    return s;
}

SceneValues::SceneValues(const Scene& scene, const std::vector<AskedValue>& values,
                         const Digits& digits)
    : scene_(asking(scene, values, digits)), plan_(make_plan(scene_)),
      route_(plan_.proved ? make_ball_route(scene_, plan_, work_)
                          : make_real_route(scene_, plan_, work_)) {}

BoundedValue SceneValues::value(const AskedValue& asked) {
    const QuantityRow& row = row_of(asked.quantity);
    if (row.searched == nullptr) {
        return route_->value(asked);
    }
    const ExtentValues& found = extent(asked);
    if (row.searched == &ExtentValues::first_exit && !found.leaves) {
        throw DomainError("there is no first exit: the terms stay within the tolerance");
    }
    return found.*row.searched;
}

BoundedValue SceneValues::x(const AskedValue& asked) {
    if (asked.u->sign() <= 0) {
        throw DomainError("the point lies outside the contact");
    }
    return route_->place(asked.edge, asked.distance());
}

const ExtentValues& SceneValues::extent(const AskedValue& asked) {
    const std::pair key{asked.edge, asked.k};
    const auto known = extents_.find(key);
    return known != extents_.end()
               ? known->second
               : extents_.emplace(key, route_->extent(asked.edge, asked.k)).first->second;
}

} // namespace edgeproof::scene
