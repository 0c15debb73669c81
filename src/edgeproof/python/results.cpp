// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/python/results.hpp"

#include "edgeproof/python/value.hpp"

#include <optional>
#include <utility>

namespace py = pybind11;

namespace edgeproof::python {
namespace {

using scene::Quantity;

/// Makes values with one number of digits.
class Maker {
public:
    explicit Maker(unsigned digits) : digits_(digits) {}

    [[nodiscard]] py::object operator()(const scene::BoundedValue& x) const {
        return py::cast(Value(x, digits_));
    }
    /// None if there is no such row, or if its value was not found.
    [[nodiscard]] py::object operator()(const scene::Row* row) const {
        return row != nullptr && row->value ? (*this)(*row->value) : py::object(py::none());
    }

private:
    unsigned digits_;
};

py::dict contact_of(const scene::SceneResult& result, const Maker& value) {
    py::dict d;
    for (const Quantity q : {Quantity::a, Quantity::b, Quantity::P, Quantity::M, Quantity::alpha}) {
        d[py::str(scene::symbol_of({q}))] = value(result.find(q));
    }
    return d;
}

const char* state_name(const std::optional<contact::SlipState>& state) {
    using contact::SlipState;
    return state == SlipState::stick ? "stick" : state == SlipState::slip ? "slip" : "undecided";
}

py::list approximations(const scene::RowsAt& point, Quantity local, Quantity error,
                        const Maker& value, const Maker& short_value) {
    py::list out;
    for (const scene::Row& row : point) {
        if (row.asked.quantity == local) {
            out.append(py::make_tuple(row.asked.k, value(&row),
                                      short_value(point.find(error, row.asked.k))));
        }
    }
    return out;
}

py::dict point_of(const scene::RowsAt& point, const Maker& value, const Maker& error) {
    const scene::Row* const u = point.find(Quantity::u);
    const scene::Row* const q = point.find(Quantity::q);
    py::dict d;
    d["edge"] = scene::edge_name(point.edge());
    d["u"] = u != nullptr ? value(u) : py::object(py::str(point.row(Quantity::x).asked.u->text()));
    d["x"] = value(point.find(Quantity::x));
    d["p"] = value(point.find(Quantity::p));
    d["p_local"] = approximations(point, Quantity::local, Quantity::rel, value, error);
    d["q"] = value(q);
    d["q_local"] = approximations(point, Quantity::q_local, Quantity::q_rel, value, error);
    py::dict others;
    for (const scene::Row& row : point) {
        if (row_of(row.asked.quantity).by_its_own_name()) {
            others[py::str(scene::symbol_of(row.asked))] = value(&row);
        }
    }
    d["others"] = others;
    d["state"] = q != nullptr && q->state ? py::object(py::str(state_name(q->state)))
                                          : py::object(py::none());
    return d;
}

py::dict coefficients_of(const scene::Scene& scene, const scene::RowsAt& edge, const Maker& value) {
    py::list c;
    py::list s;
    for (const scene::Row& row : edge) {
        (row.asked.quantity == Quantity::c ? c : s).append(value(&row));
    }
    py::dict d;
    d["edge"] = scene::edge_name(edge.edge());
    d["c"] = c;
    d["s"] = s;
    d["s_half_powers"] = scene::shear_half_powers(scene);
    return d;
}

py::dict extent_of(const scene::Scene& scene, const scene::RowsAt& edge, std::size_t n,
                   const Maker& value) {
    const scene::Row& exit = edge.row(Quantity::extent, n);
    py::dict d;
    d["edge"] = scene::edge_name(edge.edge());
    d["terms"] = n;
    d["leaves"] = exit.reached;
    d["first_exit"] = value(&exit);
    d["measure"] = value(edge.find(Quantity::measure, n));
    d["first_exit_fraction"] = value(edge.find(Quantity::extent_fraction, n));
    d["measure_fraction"] = value(edge.find(Quantity::measure_fraction, n));
    py::list crossings;
    for (std::size_t j = 0; const scene::Row* row = edge.find(Quantity::crossing, n, j); ++j) {
        crossings.append(value(row));
    }
    d["crossings"] = crossings;
    d["covers_zone"] = scene.ask.process_zone
                           ? py::object(py::bool_(covers_zone(scene, *exit.value)))
                           : py::object(py::none());
    return d;
}

py::dict slip_of(const scene::Scene& scene, const scene::RowsAt& edge, const Maker& value,
                 const Maker& error) {
    py::dict d;
    d["edge"] = scene::edge_name(edge.edge());
    d["size"] = value(edge.find(Quantity::slip));
    py::list terms;
    for (const std::size_t n : scene.ask.terms) {
        const scene::Row& load = edge.row(Quantity::slip_load, n);
        terms.append(py::make_tuple(n, value(edge.find(Quantity::slip_terms, n)),
                                    error(edge.find(Quantity::slip_rel, n)), value(&load),
                                    load.reached));
    }
    d["terms"] = terms;
    return d;
}

py::object stick_of(const scene::SceneResult& result, const Maker& value) {
    if (!result.plan.partial_slip) {
        return py::none();
    }
    py::dict d;
    for (const auto& [key, quantity] :
         {std::pair{"load_ratio", Quantity::load_ratio}, std::pair{"a", Quantity::stick_a},
          std::pair{"b", Quantity::stick_b},
          std::pair{"least_bulk_tension", Quantity::least_tension},
          std::pair{"most_bulk_tension", Quantity::most_tension},
          std::pair{"cycle_energy", Quantity::cycle_energy}}) {
        d[key] = value(result.find(quantity));
    }
    d["in_proportion"] = result.in_proportion;
    return d;
}

} // namespace

py::dict results_of(const scene::Scene& scene, const scene::SceneResult& result) {
    const Maker value(scene.ask.digits.count);
    const Maker error(result.plan.error_digits().count);
    py::dict d;
    d["contact"] = contact_of(result, value);
    py::list points;
    for (const scene::RowsAt& point : result.points()) {
        points.append(point_of(point, value, error));
    }
    d["points"] = points;
    py::list coefficients;
    for (const scene::RowsAt& edge : result.at_edges(scene::QuantityGroup::coefficients)) {
        coefficients.append(coefficients_of(scene, edge, value));
    }
    d["coefficients"] = coefficients;
    py::list extents;
    for (const scene::RowsAt& edge : result.at_edges(scene::QuantityGroup::extent)) {
        for (const std::size_t n : scene.ask.terms) {
            extents.append(extent_of(scene, edge, n, value));
        }
    }
    d["extents"] = extents;
    d["stick"] = stick_of(result, value);
    py::list slips;
    for (const scene::RowsAt& edge : result.at_edges(scene::QuantityGroup::slip)) {
        slips.append(slip_of(scene, edge, value, error));
    }
    d["slips"] = slips;
    d["proved"] = result.plan.proved;
    d["why"] = result.plan.proved_why;
    return d;
}

py::dict asked_of(const scene::Scene& scene) {
    py::dict d;
    py::list quantities;
    for (const scene::QuantityGroup group : scene.ask.quantities) {
        quantities.append(scene::group_name(group));
    }
    d["quantities"] = quantities;
    py::list edges;
    for (const contact::Edge edge : scene.ask.edges) {
        edges.append(scene::edge_name(edge));
    }
    d["edges"] = edges;
    py::list terms;
    for (const std::size_t n : scene.ask.terms) {
        terms.append(n);
    }
    d["terms"] = terms;
    py::list u;
    for (const scene::AskedPoint& point : scene.ask.u) {
        u.append(point.text());
    }
    d["u"] = u;
    d["tolerance"] = scene.ask.tolerance ? py::object(py::str(scene.ask.tolerance->text()))
                                         : py::object(py::none());
    d["digits"] = scene.ask.digits.count;
    return d;
}

} // namespace edgeproof::python
