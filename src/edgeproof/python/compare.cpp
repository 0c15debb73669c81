// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/comparison/comparison.hpp"

#include "edgeproof/precision/rounding/text.hpp"
#include "edgeproof/python/bindings.hpp"
#include "edgeproof/python/native_scene.hpp"
#include "edgeproof/python/without_gil.hpp"
#include "edgeproof/report/tables/comparison_report.hpp"

#include <pybind11/stl.h>

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace py = pybind11;
using namespace py::literals;

namespace edgeproof::python {
namespace {

using OptionalText = std::optional<std::string>;

/// Texts of result tables, each with its name for errors.
using Results = std::vector<std::pair<std::string, std::string>>;

std::optional<double> tolerance_of(const OptionalText& text) {
    return text ? std::optional(scene::parse_tolerance(*text).to<double>()) : std::nullopt;
}

py::dict compare(const NativeScene& native, const std::string& name, const Results& results,
                 const std::string& columns, const std::string& scale, const OptionalText& origin,
                 const OptionalText& tolerance, const std::string& of, const std::string& edge_zone,
                 const OptionalText& tolerance_a, const OptionalText& tolerance_P,
                 const OptionalText& tolerance_c0, bool partial, py::object callback) {
    const auto [json, text] = with_progress(std::move(callback), [&](Progress& progress) {
        const scene::Scene& scene = native.scene();
        comparison::Tolerances t;
        t.partial = partial;
        const auto of_pressure = tolerance_of(tolerance);
        t.stated = of_pressure.has_value();
        t.pressure = of_pressure.value_or(t.pressure);
        t.of = comparison::norm_named(of);
        t.zone = comparison::parse_edge_zone(edge_zone);
        t.edges = tolerance_of(tolerance_a);
        t.force = tolerance_of(tolerance_P);
        t.c0 = tolerance_of(tolerance_c0);
        const auto at = origin == "auto"
                            ? std::nullopt // fitted to the data
                            : std::optional(origin ? parse_decimal(*origin) : Rational(0));
        const comparison::ResultReading reading =
            comparison::reading_of(scene.units, columns, scale);
        std::vector<comparison::ResultTable> tables; // all are read before any work
        for (const auto& [written, file] : results) {
            tables.push_back(comparison::parse_result(written, file, reading));
        }
        const comparison::ExactContact exact(scene);
        const report::ComparisonReport report{
            name, scene.title, scene.units, &exact,
            compare_tables(std::move(tables), scene, exact, t, at, std::ref(progress))};
        return std::pair(comparison_json(report), comparison_text(report));
    });
    return py::dict("json"_a = json, "text"_a = text);
}

} // namespace

void bind_compare(py::module_& module) {
    module.def("compare", &compare, "scene"_a, "name"_a, "results"_a, "columns"_a, "scale"_a,
               "origin"_a, "tolerance"_a, "of"_a, "edge_zone"_a, "tolerance_a"_a, "tolerance_P"_a,
               "tolerance_c0"_a, "partial"_a, "progress"_a);
}

} // namespace edgeproof::python
