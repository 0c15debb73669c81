// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/edgeproof.hpp"
#include "edgeproof/python/bindings.hpp"
#include "edgeproof/python/without_gil.hpp"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace py = pybind11;
using namespace py::literals;

namespace edgeproof::python {
namespace {

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

std::span<const double> numbers_in(const Doubles& array) {
    return {array.data(), static_cast<std::size_t>(array.size())};
}

/// Returns a new array of the same shape.
py::array_t<double> array_like(const Doubles& array) {
    return py::array_t<double>(
        std::vector<py::ssize_t>(array.shape(), array.shape() + array.ndim()));
}
std::span<double> numbers_of(py::array_t<double>& array) {
    return {array.mutable_data(), static_cast<std::size_t>(array.size())};
}

/// Returns "p", "q", "local" or "rel" at many places: coordinates x, or distances from the edge.
py::array_t<double> binary64(const Scene& self, const std::string& quantity, long terms,
                             const std::string& edge, bool by_x, const Doubles& places) {
    const std::span<const double> from = numbers_in(places);
    const auto wrong = std::ranges::find_if(from, [](double x) { return std::isnan(x); });
    if (wrong != from.end()) {
        throw InputError(element_name(places, by_x ? "x" : "u", wrong - from.begin()) +
                             " is not a number",
                         "give places as numbers");
    }
    py::array_t<double> values = array_like(places);
    const std::span<double> to = numbers_of(values);
    without_gil([&] { self.binary64(quantity, terms, edge, by_x, from, to); });
    return values;
}

/// Returns the stresses at points of a body, and the bound of their errors; mises if it is asked
/// for.
py::dict stresses(const Scene& self, bool body_B, const Doubles& x, const Doubles& z, bool mises) {
    std::map<std::string, py::array_t<double>> arrays;
    const auto array = [&](const char* name) {
        return numbers_of(arrays.emplace(name, array_like(x)).first->second);
    };
    const Stresses out{array("sxx"),
                       array("szz"),
                       array("sxz"),
                       array("tau_max"),
                       mises ? array("mises") : std::span<double>(),
                       array("bound")};
    without_gil([&] { self.stresses(numbers_in(x), numbers_in(z), out, body_B); });
    return py::cast(arrays);
}

} // namespace

void bind_scene(py::module_& module) {
    py::class_<Scene> native(module, "NativeScene");
    native.def_static("from_text", apart(&Scene::from_text), "text"_a, "file"_a)
        .def_static("from_keys", apart(&Scene::from_keys), "sections"_a, "title"_a)
        .def_property_readonly("text", &Scene::text)
        .def("facts", &Scene::facts)
        .def("run", apart(&Scene::run), "asked"_a)
        .def("pictures", apart(&Scene::pictures), "asked"_a, "field"_a, "body_B"_a)
        .def("greatest", apart(&Scene::greatest), "quantity"_a, "body_B"_a, "digits"_a)
        .def("stress_terms", apart(&Scene::stress_terms), "asked"_a, "angle"_a, "body_B"_a)
        .def("binary64", &binary64, "quantity"_a, "terms"_a, "edge"_a, "by_x"_a, "places"_a)
        .def("stresses", &stresses, "body_B"_a, "x"_a, "z"_a, "mises"_a);
    refuse_new(native);
}

} // namespace edgeproof::python
