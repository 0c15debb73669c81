// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/report/tables/relations_table.hpp"

#include "edgeproof/python/bindings.hpp"
#include "edgeproof/python/without_gil.hpp"

#include <pybind11/stl.h>

#include <string>
#include <utility>
#include <vector>

namespace py = pybind11;

namespace edgeproof::python {
namespace {

/// Returns the JSON of `edgeproof relations`.
std::string relations(std::vector<std::string> quantities, long degree, bool symmetric,
                      std::vector<std::pair<std::string, std::string>> given,
                      std::vector<std::string> free) {
    const audit::RelationQuestion question{std::move(quantities), degree, symmetric,
                                           std::move(given), std::move(free)};
    return without_gil([&] {
        return write_table(report::relations_table(question, asked_relations(question)),
                           report::TableFormat::json);
    });
}

} // namespace

void bind_relations(py::module_& module) {
    module.def("relations", &relations, py::arg("quantities"), py::arg("degree"),
               py::arg("symmetric"), py::arg("given"), py::arg("free"));
}

} // namespace edgeproof::python
