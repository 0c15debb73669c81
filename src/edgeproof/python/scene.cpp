// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/io/text_file.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/python/bindings.hpp"
#include "edgeproof/python/native_scene.hpp"
#include "edgeproof/python/results.hpp"
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

using Texts = std::vector<std::string>;
using Keys = std::vector<std::pair<std::string, std::variant<bool, std::string, Texts>>>;

scene::SceneEntries::Section entries_of(const Keys& keys) {
    scene::SceneEntries::Section entries;
    for (const auto& [key, value] : keys) {
        io::TomlEntry entry{key, {}};
        std::visit([&](const auto& v) { entry.value = v; }, value);
        entries.push_back(std::move(entry));
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

py::dict run(const NativeScene& self, std::optional<Texts> edges, std::optional<Texts> u,
             std::optional<std::vector<long>> terms, std::optional<Texts> quantities,
             std::optional<std::string> tolerance, std::optional<std::string> process_zone,
             std::optional<Texts> part, std::optional<long> digits) {
    const AskedByName ask{std::move(edges),     std::move(u),
                          std::move(terms),     std::move(quantities),
                          std::move(tolerance), std::move(process_zone),
                          std::move(part),      digits};
    std::optional<scene::Scene> scene;
    const scene::SceneResult result = without_gil([&] {
        scene = self.asking(ask);
        return scene::run_scene(*scene);
    });
    return results_of(*scene, result);
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
        .def_property_readonly("knots",
                               [](const NativeScene& s) {
                                   Texts knots;
                                   for (const auto& knot : s.scene().profile
                                                               ? s.scene().profile->knots()
                                                               : std::vector<formula::Exact>{}) {
                                       knots.push_back(knot.text());
                                   }
                                   return knots;
                               })
        .def_property_readonly("asked", [](const NativeScene& s) { return asked_of(s.scene()); })
        .def("run", &run, py::kw_only(), py::arg("edges") = py::none(), py::arg("u") = py::none(),
             py::arg("terms") = py::none(), py::arg("quantities") = py::none(),
             py::arg("tolerance") = py::none(), py::arg("process_zone") = py::none(),
             py::arg("part") = py::none(), py::arg("digits") = py::none())
        .def("pressures", &pressures, py::arg("edge"), py::arg("u"));
    module.def(
        "read_text",
        [](const std::string& file, const std::string& what) { return io::read_text(file, what); },
        py::arg("file"), py::arg("what"));
}

} // namespace edgeproof::python
