// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/formula/exact/enclosure.hpp"
#include "edgeproof/io/text_file.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/python/bindings.hpp"
#include "edgeproof/python/native_scene.hpp"
#include "edgeproof/python/without_gil.hpp"
#include "edgeproof/report/figures/scene_figure.hpp"
#include "edgeproof/scene/binary64_values.hpp"
#include "edgeproof/scene/input/scene_file.hpp"
#include "edgeproof/scene/run_scene.hpp"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace py = pybind11;
using namespace py::literals;

namespace edgeproof::python {
namespace {

constexpr long most_terms = 400;

using Keys = std::vector<std::pair<std::string, KeyValue>>;

NativeScene from_entries(const std::string& title, const Keys& profile, const Keys& load,
                         const Keys& shear, const std::vector<Keys>& steps) {
    std::vector<io::TomlTable> tables{{"profile", 0, entries_of(profile)},
                                      {"load", 0, entries_of(load)},
                                      {"shear", 0, entries_of(shear)}};
    for (const Keys& step : steps) {
        tables.push_back({"[[step]]", 0, entries_of(step)});
    }
    return without_gil([&] {
        scene::Scene scene = scene::make_scene(tables, title);
        return NativeScene(scene::scene_text(tables, title), std::move(scene));
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
py::tuple row_of(const scene::Scene& scene, const scene::Row& row) {
    const scene::AskedValue& asked = row.asked;
    const scene::QuantityRow& def = scene::row_of(asked.quantity);
    const scene::Digits digits = digits_of(asked.quantity, scene.ask.digits);
    const bool covers = asked.quantity == scene::Quantity::extent && scene.ask.process_zone;
    using Place = scene::QuantityRow::Place;
    static constexpr std::array places{"contact", "edge", "point", "body", "surface"};
    static_assert(static_cast<std::size_t>(Place::surface) + 1 == places.size());
    return py::make_tuple(
        def.symbol.empty() ? def.label : def.symbol, asked.k, asked.j,
        places.at(static_cast<std::size_t>(def.place)), scene::edge_name(asked.edge),
        def.at_point() || def.of_bodies() ? py::object(py::int_(row.point)) : py::none(),
        asked.u ? py::object(py::str(asked.u->text())) : py::none(),
        row.value ? py::cast(Value(*row.value, digits.count)) : py::none(), row.reached,
        slip_state(row),
        covers ? py::object(py::bool_(covers_zone(scene, *row.value))) : py::none());
}

template <class List, class Text> Texts texts_of(const List& list, const Text& text) {
    Texts all;
    std::ranges::transform(list, std::back_inserter(all), text);
    return all;
}

/// Returns a place x as a number if it is one, else as it was written.
std::string place_text(const scene::AskedPoint& point) {
    const auto number = point.place ? point.place->number() : std::nullopt;
    return number ? number->text() : point.text();
}

/// Returns the rows of a result, from which edgeproof/results.py makes its objects.
py::dict run(const NativeScene& self, const std::map<std::string, KeyValue>& asked) {
    std::optional<scene::Scene> scene;
    const scene::SceneResult result = without_gil([&] {
        scene = self.asking(asked);
        return scene::run_scene(*scene);
    });
    py::list rows;
    for (const scene::Row& row : result.rows) {
        rows.append(row_of(*scene, row));
    }
    py::list points;
    for (const scene::BodyPoint& point : scene->ask.in_bodies) {
        points.append(py::make_tuple(point.body == scene::Body::A ? "A" : "B", point.x.text(),
                                     point.z.text()));
    }
    return py::dict("rows"_a = rows, "points"_a = points,
                    "places"_a = texts_of(scene->ask.u, place_text),
                    "s_half_powers"_a = scene::shear_half_powers(*scene),
                    "in_proportion"_a = result.in_proportion,
                    "proved"_a = std::ranges::all_of(result.rows, [](const scene::Row& row) {
                        return !row.value || row.value->proved;
                    }));
}

/// Returns the questions of a scene's file: quantities, edges, terms, u, digits.
py::dict asked_of(const scene::Scene& scene) {
    const auto& tolerance = scene.ask.tolerance;
    return py::dict(
        "quantities"_a = texts_of(scene.ask.quantities, scene::group_name),
        "edges"_a = texts_of(scene.ask.edges, scene::edge_name), "terms"_a = scene.ask.terms,
        "u"_a = texts_of(scene.ask.u, [](const scene::AskedPoint& point) { return point.text(); }),
        "tolerance"_a = text_or_none(tolerance ? tolerance->text() : ""),
        "digits"_a = scene.ask.digits.count);
}

/// Returns the name of the element at a place in memory: "u[3]", "u[0, 2]".
std::string element_name(const py::array& u, const std::string& name, py::ssize_t place) {
    std::string indices;
    for (py::ssize_t k = u.ndim(); k-- > 0;) {
        indices = std::to_string(place % u.shape(k)) + (indices.empty() ? "" : ", ") + indices;
        place /= u.shape(k);
    }
    return indices.empty() ? name : name + "[" + indices + "]";
}

using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// Calls `compute` with the places and the array of the values, without the GIL.
template <class Compute>
py::array_t<double> for_each_place(const Doubles& places, const char* name,
                                   const Compute& compute) {
    py::array_t<double> values(
        std::vector<py::ssize_t>(places.shape(), places.shape() + places.ndim()));
    const std::span<const double> from(places.data(), static_cast<std::size_t>(places.size()));
    const std::span<double> to(values.mutable_data(), from.size());
    const auto wrong = std::ranges::find_if(from, [](double x) { return std::isnan(x); });
    if (wrong != from.end()) {
        throw InputError(element_name(places, name, wrong - from.begin()) + " is not a number",
                         "give places as numbers");
    }
    without_gil([&] { compute(from, to); });
    return values;
}

/// Returns "p", "q", "local" or "rel" at many places: coordinates x, or distances from the edge.
py::array_t<double> binary64(const NativeScene& self, const std::string& quantity, long terms,
                             const std::string& edge, bool by_x, const Doubles& places) {
    require(terms >= 0 && terms <= most_terms,
            "terms = " + std::to_string(terms) + " is out of range",
            "give a number from 1 to " + std::to_string(most_terms));
    using scene::Quantity;
    static const std::map<std::string, Quantity> named{
        {"p", Quantity::p}, {"q", Quantity::q}, {"local", Quantity::local}, {"rel", Quantity::rel}};
    const scene::Binary64Question question{named.at(quantity), static_cast<std::size_t>(terms),
                                           by_x};
    const contact::Edge at = scene::edge_of(edge);
    return for_each_place(places, by_x ? "x" : "u",
                          [&](std::span<const double> from, std::span<double> to) {
                              self.binary64(question, at, from, to);
                          });
}

/// Returns the panels of `edgeproof plot`: their axes, and curves of points (x, y).
py::list plots(const NativeScene& self, const std::map<std::string, KeyValue>& asked) {
    const std::vector<report::Plot> found = without_gil(
        [&] { return report::scene_picture(self.asking(asked), [](std::size_t, std::size_t) {}); });
    const auto number = [](const Real& x) { return x.convert_to<double>(); };
    const auto axis = [](const report::Axis& of) {
        return py::make_tuple(of.label, of.logarithmic, of.range);
    };
    py::list panels;
    for (const report::Plot& plot : found) {
        py::list curves;
        for (std::size_t i = 0; i < plot.curves.size(); ++i) {
            const report::Curve& curve = plot.curves[i];
            std::vector<double> x;
            std::vector<double> y;
            for (const auto& row : plot.rows) {
                if (const auto& value = row[i + 1]) {
                    x.push_back(number(*row[0]));
                    y.push_back((plot.y.percent ? 100 : 1) * number(*value));
                }
            }
            const report::Pen& pen = curve.pen;
            curves.append(py::make_tuple(curve.title, static_cast<int>(pen.colour), pen.dash,
                                         pen.point, pen.width, x, y));
        }
        panels.append(py::dict("title"_a = plot.title, "x"_a = axis(plot.x), "y"_a = axis(plot.y),
                               "curves"_a = curves, "level"_a = plot.level));
    }
    return panels;
}

/// Returns the stresses at points of a body, and the bound of their errors.
py::dict stresses(const NativeScene& self, const std::string& body, const Doubles& x,
                  const Doubles& z) {
    if (x.size() != z.size()) {
        throw Error("x and z differ in size");
    }
    const scene::Body at = scene::body_named(body);
    const std::vector<py::ssize_t> shape(x.shape(), x.shape() + x.ndim());
    py::dict arrays;
    const auto array = [&](const char* name) {
        py::array_t<double> made(shape);
        const std::span<double> values(made.mutable_data(), static_cast<std::size_t>(x.size()));
        arrays[name] = std::move(made);
        return values;
    };
    const scene::Binary64Stresses out{array("sxx"),
                                      array("szz"),
                                      array("sxz"),
                                      array("tau_max"),
                                      self.scene().poisson(at) ? array("mises")
                                                               : std::span<double>(),
                                      array("bound")};
    const std::span<const double> across(x.data(), static_cast<std::size_t>(x.size()));
    const std::span<const double> depths(z.data(), across.size());
    without_gil([&] { compute_binary64(self.scene(), at, across, depths, out); });
    return arrays;
}

/// Returns the binary64 nearest to a number as the library reads it ("pi/16").
double nearest_to(const std::string& text) { return formula::Exact::parse(text).to<double>(); }

/// Returns a number as a Value.
Value given(const std::string& text, unsigned digits) {
    const formula::Exact x = formula::Exact::parse(text);
    const long bits = formula::bits_for(digits) + 64;
    return {{ball_of(x, bits), true, "given", rational_of(x)}, digits};
}

} // namespace

void bind_scene(py::module_& module) {
    py::class_<NativeScene> native(module, "NativeScene");
    native
        .def_static(
            "from_text",
            [](const std::string& text, const std::string& file) {
                return without_gil(
                    [&] { return NativeScene(text, scene::parse_scene(text, file)); });
            },
            "text"_a, "file"_a)
        .def_static("from_entries", &from_entries, "title"_a, "profile"_a, "load"_a, "shear"_a,
                    "steps"_a)
        .def_property_readonly("text", &NativeScene::text)
        .def_property_readonly("file", [](const NativeScene& s) { return s.scene().file; })
        .def_property_readonly("title", [](const NativeScene& s) { return s.scene().title; })
        .def_property_readonly("symmetric",
                               [](const NativeScene& s) { return s.scene().symmetric(); })
        .def_property_readonly("has_shear",
                               [](const NativeScene& s) { return s.scene().shear.has_value(); })
        .def_property_readonly("slips", [](const NativeScene& s) { return s.scene().slips(); })
        .def_property_readonly("integrated",
                               [](const NativeScene& s) { return !s.scene().closed(); })
        .def_property_readonly("asked", [](const NativeScene& s) { return asked_of(s.scene()); })
        .def("run", &run, "asked"_a)
        .def("plots", &plots, "asked"_a)
        .def("binary64", &binary64, "quantity"_a, "terms"_a, "edge"_a, "by_x"_a, "places"_a)
        .def("stresses", &stresses, "body"_a, "x"_a, "z"_a);
    refuse_new(native);
    module.def("nearest_to", &nearest_to, "text"_a);
    module.def("given", &given, "text"_a, "digits"_a);
    module.def(
        "read_text",
        [](const std::string& file, const std::string& what) { return io::read_text(file, what); },
        "file"_a, "what"_a);
}

} // namespace edgeproof::python
