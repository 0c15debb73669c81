// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/python/bindings.hpp"

PYBIND11_MODULE(_edgeproof, module) {
    module.doc() = "The compiled part of edgeproof; use the package edgeproof.";
    module.attr("__version__") = EDGEPROOF_VERSION;
    edgeproof::python::bind_errors(module);
    edgeproof::python::bind_value(module);
    edgeproof::python::bind_scene(module);
    edgeproof::python::bind_audit(module);
    edgeproof::python::bind_check(module);
    edgeproof::python::bind_compare(module);
    edgeproof::python::bind_design(module);
    edgeproof::python::bind_relations(module);
}
