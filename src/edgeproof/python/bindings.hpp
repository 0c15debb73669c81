// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <pybind11/pybind11.h>

/// The Python module: edgeproof.hpp as Python objects. It computes nothing itself. The package
/// edgeproof makes the objects of users from these.
///   module.cpp   the exceptions as those of edgeproof.errors; verify, check, compare, ... as JSON
///   value.cpp    Value
///   scene.cpp    NativeScene
namespace edgeproof::python {

/// Makes T.__new__(T) a TypeError: the object would have no value.
void refuse_new(const pybind11::handle& type);

void bind_value(pybind11::module_& module);
void bind_scene(pybind11::module_& module);

} // namespace edgeproof::python
