// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/scene/run_scene.hpp"
#include "edgeproof/formula/exact/exact.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <tuple>
#include <utility>

namespace edgeproof::scene {
namespace {

/// Returns the rows to compute, with empty values, in the order of the results. Searches are
/// represented by their first row.
std::vector<Row> asked_rows(const Scene& scene, const Plan& plan) {
    const Ask& ask = scene.ask;
    std::vector<Row> rows;
    const auto add = [&](const AskedValue& asked) { rows.push_back({asked}); };
    for (const QuantityRow& row : quantity_rows()) {
        const bool wanted = row.quantity == Quantity::a || row.quantity == Quantity::b ||
                            row.quantity == Quantity::alpha || row.quantity == Quantity::delta ||
                            row.quantity == Quantity::stiffness || ask.wants(row.group);
        if ((row.group == QuantityGroup::contact || row.group == QuantityGroup::peak) && wanted &&
            !row.at_edge() && !lack_of(scene, {row.quantity})) {
            add({row.quantity});
        }
    }
    if (plan.partial_slip) {
        const bool all = ask.wants(QuantityGroup::slip);
        const bool tension = all && scene.shear->bulk_tension.sign() != 0;
        const auto known = [&](Quantity energy) { return all && !lack_of(scene, {energy}); };
        for (const auto& [quantity, wanted] :
             {std::pair{Quantity::stick_a, true},
              {Quantity::stick_b, true},
              {Quantity::load_ratio, true},
              {Quantity::least_tension, tension},
              {Quantity::most_tension, tension},
              {Quantity::step_energy, known(Quantity::step_energy)},
              {Quantity::cycle_energy, known(Quantity::cycle_energy)}}) {
            if (wanted) {
                add({quantity});
            }
        }
    }
    for (const Edge edge : ask.edges) {
        for (std::size_t i = 0; i < plan.points; ++i) {
            const AskedPoint& point = ask.u[i];
            const Distance u = point.distance(edge);
            const auto at = [&](Quantity quantity, std::size_t n = 0) {
                AskedValue asked{quantity, n, edge, u.number()};
                if (!u.number()) {
                    asked.place = u;
                }
                rows.push_back({std::move(asked), {}, i});
            };
            at(Quantity::x);
            if (!u.number()) {
                at(Quantity::u);
            }
            const auto value = [&](QuantityGroup group, Quantity quantity, bool terms,
                                   Quantity local, Quantity rel) {
                if (!ask.wants(group)) {
                    return;
                }
                at(quantity);
                for (const std::size_t n : terms ? ask.terms : std::vector<std::size_t>{}) {
                    at(local, n);
                    at(rel, n);
                }
            };
            value(QuantityGroup::pressure, Quantity::p, plan.terms > 0, Quantity::local,
                  Quantity::rel);
            value(QuantityGroup::shear, Quantity::q, plan.terms > 0 && plan.expand_shear,
                  Quantity::q_local, Quantity::q_rel);
        }
    }
    const auto of_bodies = [&](QuantityRow::Place place, std::size_t point, AskedValue asked) {
        for (const QuantityRow& row : quantity_rows()) {
            asked.quantity = row.quantity;
            if (row.place == place && ask.wants(row.group) && !lack_of(scene, asked)) {
                rows.push_back({asked, {}, point});
            }
        }
    };
    for (std::size_t i = 0; i < ask.in_bodies.size(); ++i) {
        of_bodies(QuantityRow::Place::body, i, {.in_body = ask.in_bodies[i]});
    }
    for (std::size_t i = 0; i < ask.u.size(); ++i) {
        of_bodies(QuantityRow::Place::surface, i,
                  {.place = ask.u[i].distance(Edge::right),
                   .in_body = scene::BodyPoint{{}, {}, ask.surface_of},
                   .reference = ask.reference});
    }
    for (const Edge edge : ask.edges) {
        for (std::size_t k = 0; ask.wants(QuantityGroup::coefficients) && k < plan.terms; ++k) {
            add({Quantity::c, k, edge});
            if (plan.expand_shear) {
                add({Quantity::s, k, edge});
            }
        }
    }
    const std::vector<std::size_t> none;
    for (const Edge edge : ask.edges) {
        for (const std::size_t n : ask.wants(QuantityGroup::extent) ? ask.terms : none) {
            add({Quantity::extent, n, edge, {}, ask.tolerance});
        }
    }
    for (const Edge edge : ask.wants(QuantityGroup::slip) ? ask.edges : std::vector<Edge>{}) {
        add({Quantity::slip, 0, edge});
        for (const std::size_t n : scene.history ? none : ask.terms) {
            add({Quantity::slip_terms, n, edge, {}, ask.tolerance});
        }
    }
    return rows;
}

class Run {
public:
    Run(const Scene& scene, const RunProgress& progress)
        : scene_(scene), progress_(progress), values_(scene), plan_(values_.plan()) {}

    [[nodiscard]] SceneResult all() {
        result_.plan = plan_;
        std::vector<Row> rows = asked_rows(scene_, plan_);
        result_.rows.reserve(rows.size());
        for (std::size_t i = 0; i < rows.size(); ++i) {
            check_interruption();
            if (progress_) {
                progress_(i, rows.size());
            }
            if (row_of(rows[i].asked.quantity).searched) {
                search(rows[i].asked);
            } else {
                compute(rows[i]);
                if (rows[i].value) {
                    result_.rows.push_back(std::move(rows[i]));
                }
            }
        }
        if (plan_.partial_slip) {
            result_.in_proportion = values_.in_proportion();
        }
        return std::move(result_);
    }

private:
    /// True if p at this edge is computed, not copied from the first edge of a symmetric contact.
    [[nodiscard]] bool computes(Edge edge) const {
        return !scene_.symmetric() || edge == scene_.ask.edges.front();
    }
    /// True if the value is that of the mirror image at the first edge.
    [[nodiscard]] bool mirrored(const Row& row) const {
        const Quantity quantity = row.asked.quantity;
        const QuantityRow& def = row_of(quantity);
        if (computes(row.asked.edge) || quantity == Quantity::x || quantity == Quantity::u ||
            def.of_friction() || (def.of_shear() && !scene_.proportional())) {
            return false;
        }
        // The mirror image of a place given by x is another place.
        return !def.at_point() || !is_by_x(row);
    }
    [[nodiscard]] bool is_by_x(const Row& row) const {
        const AskedPoint& point = scene_.ask.u[row.point];
        return point.place && point.place->from() == Place::From::origin;
    }
    void compute(Row& row) {
        const QuantityRow& def = row_of(row.asked.quantity);
        const auto key = std::tuple(row.asked.quantity, row.asked.k, row.point);
        if (def.at_edge() && mirrored(row)) {
            const Row& image = result_.rows[images_.at(key)];
            row.value = image.value;
            row.state = image.state;
            return;
        }
        if (outside_ == std::pair(row.asked.edge, row.point) && def.at_point()) {
            compute_outside(row);
            return;
        }
        try {
            row.value = values_.value(row.asked);
            if (row.asked.quantity == Quantity::q && scene_.slips()) {
                row.state = values_.state(row.asked.edge, row.asked.distance());
            }
        } catch (const Error& error) {
            if (def.may_be_missing) {
                return;
            }
            if (row.asked.quantity == Quantity::x && is_by_x(row) &&
                dynamic_cast<const OutsideContact*>(&error) != nullptr) {
                outside_ = std::pair(row.asked.edge, row.point);
                compute_outside(row);
                return;
            }
            const auto* domain = dynamic_cast<const DomainError*>(&error);
            if (domain != nullptr && def.place == QuantityRow::Place::surface) {
                return; // the gap exists outside the contact, the slip inside
            }
            if (def.of_bodies() && dynamic_cast<const InputError*>(&error) == nullptr) {
                refuse_in_body(row, error);
            }
            if (domain != nullptr) {
                refuse(row, *domain);
            }
            throw;
        }
        if (scene_.symmetric()) {
            images_.try_emplace(key, result_.rows.size());
        }
    }
    /// Gives x, p = 0 and q = 0 at a place outside the contact; nothing else has a value there.
    void compute_outside(Row& row) const {
        row.value = value_outside(row.asked.quantity, plan_.bits);
        if (row.asked.quantity == Quantity::x) {
            const std::string route = "outside the contact";
            const auto x = scene_.ask.u[row.point].place->number();
            const Ball& a = result_.at(Quantity::a).value;
            row.value =
                x ? BoundedValue{formula::ball_of(*x, plan_.bits), true, route,
                                 x->is_rational() ? std::optional(x->rational()) : std::nullopt}
                  : BoundedValue{row.asked.distance().x_enclosure(a, result_.at(Quantity::b).value,
                                                                  a.bits()),
                                 result_.at(Quantity::a).proved, route};
        }
    }
    void search(AskedValue asked) {
        const Edge edge = asked.edge;
        if (row_of(asked.quantity).group == QuantityGroup::extent && !computes(edge)) {
            asked.edge = scene_.ask.edges.front();
        }
        for (const Row& row : values_.search(asked)) {
            result_.rows.push_back(row);
            result_.rows.back().asked.edge = edge;
        }
    }
    [[noreturn]] void refuse_in_body(const Row& row, const Error& error) const {
        const QuantityRow& def = row_of(row.asked.quantity);
        const std::string what =
            def.place == QuantityRow::Place::body
                ? text_of(row.asked)
                : std::string(def.name) + " at " + scene_.ask.u[row.point].text();
        throw InputError(what + ": " + error.what(), "leave this point out")
            .at(scene_.file, scene_.ask_line);
    }
    [[noreturn]] void refuse(const Row& row, const DomainError& error) const {
        if (!row_of(row.asked.quantity).at_point()) {
            if (row.asked.quantity != Quantity::p_max) {
                throw error;
            }
            throw InputError(error.what(), "leave peak out of the quantities")
                .at(scene_.file, scene_.ask_line);
        }
        const AskedPoint& point = scene_.ask.u[row.point];
        throw InputError((is_by_x(row) ? point.text()
                                       : "u = " + point.text() + " from the " +
                                             edge_name(row.asked.edge) + " edge") +
                             ": " + error.what(),
                         is_by_x(row)
                             ? "give places of the contact, -b < x < a, off every corner"
                             : "give distances from the edge, 0 < u < a + b, off every corner")
            .at(scene_.file, point.line != 0 ? point.line : scene_.ask_line);
    }

    const Scene& scene_;
    const RunProgress& progress_;
    SceneValues values_;
    const Plan& plan_;
    SceneResult result_;
    /// The last point outside the contact, by the edge of its rows.
    std::optional<std::pair<Edge, std::size_t>> outside_;
    /// The indices of the rows at the first edge.
    std::map<std::tuple<Quantity, std::size_t, std::size_t>, std::size_t> images_;
};

/// Cuts the rows that `belongs` accepts into parts of which all rows have the same place.
template <class Belongs>
std::vector<RowsAt> by_place(std::span<const Row> rows, const Belongs& belongs) {
    std::vector<RowsAt> parts;
    for (std::size_t i = 0; i < rows.size();) {
        const Row& first = rows[i];
        std::size_t end = i;
        while (end < rows.size() && belongs(rows[end]) &&
               rows[end].asked.edge == first.asked.edge && rows[end].point == first.point) {
            ++end;
        }
        if (end > i) {
            parts.emplace_back(rows.subspan(i, end - i));
        }
        i = std::max(end, i + 1);
    }
    return parts;
}

} // namespace

std::vector<RowsAt> SceneResult::points() const {
    return by_place(rows, [](const Row& row) { return row_of(row.asked.quantity).at_point(); });
}

std::vector<RowsAt> SceneResult::at_places(QuantityRow::Place place) const {
    return by_place(rows,
                    [&](const Row& row) { return row_of(row.asked.quantity).place == place; });
}

std::vector<RowsAt> SceneResult::at_edges(QuantityGroup group) const {
    return by_place(rows, [&](const Row& row) {
        const QuantityRow& def = row_of(row.asked.quantity);
        return def.group == group && def.place == QuantityRow::Place::edge;
    });
}

int shear_half_powers(const Scene& scene) { return scene.proportional() ? 1 : -1; }

bool covers_zone(const Scene& scene, const BoundedValue& first_exit) {
    const Ball& exit = first_exit.value;
    return certainly_less(ball_of(*scene.ask.process_zone, exit.bits()), exit);
}

SceneResult run_scene(const Scene& scene, const RunProgress& progress) {
    return Run(scene, progress).all();
}

Scene asking(const Scene& scene, const std::vector<AskedValue>& values, const Digits& digits) {
    Scene s = scene;
    s.ask = Ask{};
    s.ask.edges = {Edge::right, Edge::left};
    s.ask.digits = digits;
    s.ask.part = scene.ask.part;
    bool shear = false;
    std::size_t orders = 0;
    std::set<std::size_t> numbers_of_terms;
    for (const AskedValue& v : values) {
        const QuantityRow& row = row_of(v.quantity);
        s.ask.quantities.insert(row.group);
        shear = shear || row.of_shear();
        if (row.place == QuantityRow::Place::point) {
            // The routes compute the places of `values`; the plan only needs to know of a point.
            s.ask.u.push_back({v.u.value_or(Exact::of(1)), 0});
        }
        if (v.in_body) {
            s.ask.in_bodies.push_back(*v.in_body);
            s.ask.surface_of = v.in_body->body;
        }
        if (v.reference) {
            s.ask.reference = v.reference;
        }
        // A stress or displacement depends on the shear, if there is one.
        shear = shear || row.of_bodies();
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

} // namespace edgeproof::scene
