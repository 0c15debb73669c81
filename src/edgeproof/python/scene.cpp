// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/io/text_file.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/python/bindings.hpp"
#include "edgeproof/python/native_scene.hpp"
#include "edgeproof/python/without_gil.hpp"
#include "edgeproof/scene/input/scene_file.hpp"
#include "edgeproof/scene/run_scene.hpp"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace py = pybind11;

namespace edgeproof::python {
namespace {

using Keys = std::vector<std::pair<std::string, std::variant<bool, std::string, Texts>>>;

scene::SceneEntries::Section entries_of(const Keys& keys) {
    scene::SceneEntries::Section entries;
    for (const auto& [key, value] : keys) {
        std::visit([&](const auto& v) { entries.push_back({key, v}); }, value);
    }
    return entries;
}

NativeScene from_entries(const std::string& title, const Keys& profile, const Keys& load,
                         const Keys& shear) {
    const scene::SceneEntries entries{title, entries_of(profile), entries_of(load),
                                      entries_of(shear)};
    return without_gil([&] {
        scene::Scene scene = make_scene(entries);
        return NativeScene(scene_text(entries), std::move(scene));
    });
}

py::object slip_state(const scene::Row& row) {
    using contact::SlipState;
    return !row.state ? py::object(py::none())
                      : py::str(*row.state == SlipState::stick  ? "stick"
                                : *row.state == SlipState::slip ? "slip"
                                                                : "undecided");
}

/// Returns a row as a tuple: the fields of Row in edgeproof/results.py.
py::tuple row_of(const scene::Scene& scene, const scene::Plan& plan, const scene::Row& row) {
    const scene::AskedValue& asked = row.asked;
    const scene::QuantityRow& def = scene::row_of(asked.quantity);
    const scene::Digits digits = def.short_error ? plan.error_digits() : scene.ask.digits;
    const bool covers = asked.quantity == scene::Quantity::extent && scene.ask.process_zone;
    return py::make_tuple(
        def.symbol.empty() ? def.name : def.symbol, asked.k, asked.j, scene::edge_name(asked.edge),
        def.at_point() ? py::object(py::int_(row.point)) : py::none(),
        asked.u ? py::object(py::str(asked.u->text())) : py::none(),
        row.value ? py::cast(Value(*row.value, digits.count)) : py::none(), row.reached,
        slip_state(row),
        covers ? py::object(py::bool_(covers_zone(scene, *row.value))) : py::none());
}

/// Returns the rows of a result, from which edgeproof/results.py makes its objects.
py::dict run(const NativeScene& self, const AskedByName& asked) {
    std::optional<scene::Scene> scene;
    const scene::SceneResult result = without_gil([&] {
        scene = self.asking(asked);
        return scene::run_scene(*scene);
    });
    py::list rows;
    for (const scene::Row& row : result.rows) {
        rows.append(row_of(*scene, result.plan, row));
    }
    py::dict d;
    d["rows"] = rows;
    d["s_half_powers"] = scene::shear_half_powers(*scene);
    d["in_proportion"] = result.in_proportion;
    d["proved"] = result.plan.proved;
    d["why"] = result.plan.proved_why;
    return d;
}

/// Returns the questions of a scene's file: quantities, edges, terms, u, digits.
py::dict asked_of(const scene::Scene& scene) {
    const auto texts = [](const auto& list, const auto& text) {
        Texts all;
        std::ranges::transform(list, std::back_inserter(all), text);
        return all;
    };
    const auto& tolerance = scene.ask.tolerance;
    py::dict d;
    d["quantities"] = texts(scene.ask.quantities, scene::group_name);
    d["edges"] = texts(scene.ask.edges, scene::edge_name);
    d["terms"] = scene.ask.terms;
    d["u"] = texts(scene.ask.u, &scene::AskedPoint::text);
    d["tolerance"] = text_or_none(tolerance ? tolerance->text() : "");
    d["digits"] = scene.ask.digits.count;
    return d;
}

/// Returns the name of the element at a place in memory: "u[3]", "u[0, 2]".
std::string element_name(const py::array& u, py::ssize_t place) {
    std::string indices;
    for (py::ssize_t k = u.ndim(); k-- > 0;) {
        indices = std::to_string(place % u.shape(k)) + (indices.empty() ? "" : ", ") + indices;
        place /= u.shape(k);
    }
    return indices.empty() ? "u" : "u[" + indices + "]";
}

py::array_t<double>
pressures(NativeScene& self, const std::string& edge,
          const py::array_t<double, py::array::c_style | py::array::forcecast>& u) {
    const contact::Edge at = edge_named(edge);
    py::array_t<double> p(std::vector<py::ssize_t>(u.shape(), u.shape() + u.ndim()));
    const auto count = static_cast<std::size_t>(u.size());
    const double* const from = u.data();
    double* const to = p.mutable_data();
    const double* const wrong =
        std::find_if(from, from + count, [](double x) { return std::isnan(x); });
    if (wrong != from + count) {
        throw InputError(element_name(u, wrong - from) + " is not a number",
                         "give distances from the edge");
    }
    without_gil([&] { self.pressures(at, {from, count}, {to, count}); });
    return p;
}

} // namespace

void bind_scene(py::module_& module) {
    py::class_<NativeScene>(module, "NativeScene")
        .def(py::init([](const std::string& text, const std::string& file) {
                 return without_gil(
                     [&] { return NativeScene(text, scene::parse_scene(text, file)); });
             }),
             py::arg("text"), py::arg("file"))
        .def_static("from_entries", &from_entries, py::arg("title"), py::arg("profile"),
                    py::arg("load"), py::arg("shear"))
        .def_property_readonly("text", &NativeScene::text)
        .def_property_readonly("file", [](const NativeScene& s) { return s.scene().file; })
        .def_property_readonly("title", [](const NativeScene& s) { return s.scene().title; })
        .def_property_readonly("symmetric",
                               [](const NativeScene& s) { return s.scene().symmetric(); })
        .def_property_readonly("has_shear",
                               [](const NativeScene& s) { return s.scene().shear.has_value(); })
        .def_property_readonly("slips", [](const NativeScene& s) { return s.scene().slips(); })
        .def_property_readonly("integrated",
                               [](const NativeScene& s) {
                                   const auto& profile = s.scene().profile;
                                   return profile &&
                                          !contact::BallContact::has_closed_form(*profile);
                               })
        .def_property_readonly("asked", [](const NativeScene& s) { return asked_of(s.scene()); })
        .def("run", &run, py::arg("asked"))
        .def("pressures", &pressures, py::arg("edge"), py::arg("u"));
    module.def(
        "read_text",
        [](const std::string& file, const std::string& what) { return io::read_text(file, what); },
        py::arg("file"), py::arg("what"));
}

} // namespace edgeproof::python
