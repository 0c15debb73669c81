// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/python/results.hpp"

#include "edgeproof/python/value.hpp"

#include <optional>
#include <vector>

namespace py = pybind11;

namespace edgeproof::python {
namespace {

/// Makes values with one number of digits.
class Maker {
public:
    explicit Maker(unsigned digits) : digits_(digits) {}

    [[nodiscard]] py::object operator()(const scene::BoundedValue& x) const {
        return py::cast(Value(x, digits_));
    }
    [[nodiscard]] py::object operator()(const std::optional<scene::BoundedValue>& x) const {
        return x ? (*this)(*x) : py::object(py::none());
    }
    [[nodiscard]] py::list operator()(const std::vector<scene::BoundedValue>& list) const {
        py::list out;
        for (const scene::BoundedValue& x : list) {
            out.append((*this)(x));
        }
        return out;
    }

private:
    unsigned digits_;
};

py::list approximations(const std::vector<scene::Approximation>& list, const Maker& value,
                        const Maker& error) {
    py::list out;
    for (const scene::Approximation& a : list) {
        out.append(py::make_tuple(a.n, value(a.local), error(a.relative_error)));
    }
    return out;
}

py::dict contact_of(const scene::ContactValues& c, const Maker& value) {
    py::dict d;
    d["a"] = value(c.a);
    d["b"] = value(c.b);
    d["P"] = value(c.force);
    d["M"] = value(c.moment);
    d["alpha"] = value(c.alpha);
    return d;
}

const char* state_name(const std::optional<contact::SlipState>& state) {
    using contact::SlipState;
    return state == SlipState::stick ? "stick" : state == SlipState::slip ? "slip" : "undecided";
}

py::dict point_of(const scene::PointRow& row, bool slips, const Maker& value, const Maker& error) {
    py::dict d;
    d["edge"] = scene::edge_name(row.edge);
    d["u"] = row.values.u ? value(row.values.u) : py::object(py::str(row.u.text()));
    d["x"] = value(row.values.x);
    d["p"] = value(row.values.p);
    d["p_local"] = approximations(row.values.p_local, value, error);
    d["q"] = value(row.values.q);
    d["q_local"] = approximations(row.values.q_local, value, error);
    d["state"] = row.values.q && slips ? py::object(py::str(state_name(row.values.state)))
                                       : py::object(py::none());
    return d;
}

py::dict extent_of(const scene::ExtentValues& e, const Maker& value) {
    py::dict d;
    d["edge"] = scene::edge_name(e.edge);
    d["terms"] = e.n;
    d["leaves"] = e.leaves;
    d["first_exit"] = value(e.first_exit);
    d["measure"] = value(e.measure);
    d["first_exit_fraction"] = value(e.first_exit_fraction);
    d["measure_fraction"] = value(e.measure_fraction);
    d["crossings"] = value(e.crossings);
    d["covers_zone"] =
        e.covers_zone ? py::object(py::bool_(*e.covers_zone)) : py::object(py::none());
    return d;
}

py::dict slip_of(const scene::SlipValues& s, const Maker& value, const Maker& error) {
    py::dict d;
    d["edge"] = scene::edge_name(s.edge);
    d["size"] = value(s.size);
    py::list terms;
    for (const scene::SlipTerms& t : s.terms) {
        terms.append(
            py::make_tuple(t.n, value(t.size), error(t.relative_error), value(t.reach), t.leaves));
    }
    d["terms"] = terms;
    return d;
}

py::object stick_of(const std::optional<scene::StickValues>& s, const Maker& value) {
    if (!s) {
        return py::none();
    }
    py::dict d;
    d["load_ratio"] = value(s->load_ratio);
    d["a"] = value(s->a);
    d["b"] = value(s->b);
    d["least_bulk_tension"] = value(s->least_tension);
    d["most_bulk_tension"] = value(s->most_tension);
    d["cycle_energy"] = value(s->cycle_energy);
    d["in_proportion"] = s->in_proportion;
    return d;
}

} // namespace

py::dict results_of(const scene::Scene& scene, const scene::SceneResult& result) {
    const Maker value(scene.ask.digits.count);
    const Maker error(result.plan.error_digits().count);
    py::dict d;
    d["contact"] = contact_of(result.contact, value);
    py::list points;
    for (const scene::PointRow& row : result.points) {
        points.append(point_of(row, scene.slips(), value, error));
    }
    d["points"] = points;
    py::list coefficients;
    for (const scene::EdgeValues& e : result.coefficients) {
        py::dict c;
        c["edge"] = scene::edge_name(e.edge);
        c["c"] = value(e.c);
        c["s"] = value(e.s);
        c["s_half_powers"] = e.s_half_powers;
        coefficients.append(c);
    }
    d["coefficients"] = coefficients;
    py::list extents;
    for (const scene::ExtentValues& e : result.extents) {
        extents.append(extent_of(e, value));
    }
    d["extents"] = extents;
    d["stick"] = stick_of(result.stick, value);
    py::list slips;
    for (const scene::SlipValues& s : result.slips) {
        slips.append(slip_of(s, value, error));
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
