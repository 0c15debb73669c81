// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/precision/error.hpp"
#include "edgeproof/python/bindings.hpp"
#include "edgeproof/python/without_gil.hpp"
#include "edgeproof/report/tables/design_table.hpp"

#include <pybind11/stl.h>

#include <functional>
#include <optional>
#include <string>
#include <utility>

namespace py = pybind11;
using namespace py::literals;

namespace edgeproof::python {
namespace {

contact::DesignOptions search_of(const std::string& gap, long digits) {
    contact::DesignOptions search;
    require(digits >= 2 && digits <= static_cast<long>(scene::most_design_digits),
            "digits = " + std::to_string(digits) + " is out of range",
            "give a number from 2 to " + std::to_string(scene::most_design_digits));
    search.digits = static_cast<unsigned>(digits);
    search.gap = parse_decimal(gap);
    require(search.gap > 0, "gap = " + gap + " is not positive", "give gap=\"1e-6\"");
    return search;
}

py::dict design(const std::string& text, const std::string& file, const std::string& gap,
                long digits, std::optional<std::string> maximise,
                std::optional<std::string> tolerance, std::optional<std::string> edge,
                std::optional<long> terms, py::object callback) {
    contact::DesignOptions options = search_of(gap, digits);
    io::TomlTable asked{"design", 0, {}};
    const auto ask = [&](const char* key, const std::optional<std::string>& value) {
        if (value) {
            asked.entries.push_back({key, *value});
        }
    };
    ask("maximise", maximise);
    ask("tolerance", tolerance);
    ask("edge", edge);
    ask("terms", terms ? std::optional(std::to_string(*terms)) : std::nullopt);
    scene::DesignScene design;
    scene::DesignResult result;
    const std::string json = with_progress(std::move(callback), [&](Progress& progress) {
        options.progress = std::ref(progress);
        design = scene::parse_design(
            text, file, asked.entries.empty() ? std::vector<io::TomlTable>{} : std::vector{asked});
        result = run_design(design, options);
        return write_table(report::design_table(design, result, options),
                           report::TableFormat::json);
    });
    const auto value = [&](const Ball& x) {
        return py::cast(
            Value({x, result.proved(), result.proved() ? "branch-and-bound" : "samples", {}},
                  options.digits));
    };
    const auto optional_value = [&](const std::optional<Ball>& x) {
        return x ? value(*x) : py::object(py::none());
    };
    const long bits = 4L * static_cast<long>(options.digits) + 64;
    const auto given = [&](const Rational& q) {
        return py::cast(Value({Ball(q, bits), true, "given", q}, options.digits));
    };
    const contact::BestReach& best = result.best;
    py::dict values;
    py::dict shown_at;
    py::dict printed;
    const py::str name(design.parameter);
    values[name] = value(best.value);
    if (result.proved()) {
        shown_at[name] = given(*best.shown_at);
    }
    if (design.printed) {
        printed[name] = given(*design.printed);
    }
    return py::dict("json"_a = json, "values"_a = values, "reach"_a = value(best.reach),
                    "proved"_a = result.proved(), "missing"_a = result.missing,
                    "attained"_a = best.attained, "touches_at"_a = optional_value(best.touches_at),
                    "reach_shown_at"_a = shown_at, "printed"_a = printed,
                    "reach_at_printed"_a = optional_value(result.printed_reach),
                    "falls_short_by"_a = optional_value(result.falls_short));
}

} // namespace

void bind_design(py::module_& module) {
    module.def("design", &design, "text"_a, "file"_a, "gap"_a, "digits"_a, "maximise"_a,
               "tolerance"_a, "edge"_a, "terms"_a, "progress"_a);
}

} // namespace edgeproof::python
