// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <pybind11/pybind11.h>

#include <string>

/// The Python module: the library's values, scenes, audits and conformance checks as Python
/// objects. It computes nothing itself. Each source has one function, which adds its part:
///   module.cpp   the library's exceptions as those of edgeproof.errors
///   value.cpp    Value
///   scene.cpp    NativeScene
///   audit.cpp    verify
///   check.cpp    check
///   compare.cpp  compare
///   design.cpp   design
///   relations.cpp  relations
namespace edgeproof::python {

/// Returns None for an empty text.
[[nodiscard]] inline pybind11::object text_or_none(const std::string& text) {
    return text.empty() ? pybind11::object(pybind11::none())
                        : pybind11::object(pybind11::str(text));
}

void bind_errors(pybind11::module_& module);
void bind_value(pybind11::module_& module);
void bind_scene(pybind11::module_& module);
void bind_audit(pybind11::module_& module);
void bind_check(pybind11::module_& module);
void bind_compare(pybind11::module_& module);
void bind_design(pybind11::module_& module);
void bind_relations(pybind11::module_& module);

} // namespace edgeproof::python
