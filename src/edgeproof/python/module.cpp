// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/python/bindings.hpp"

#include <exception>

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

namespace py = pybind11;

namespace edgeproof::python {
namespace {

void raise(const char* kind, const py::object& problem, const py::object& advice = py::none(),
           const py::object& file = py::none(), const py::object& line = py::none()) {
    const py::object type = py::module_::import("edgeproof.errors").attr(kind);
    const py::object error = type(problem, advice, file, line);
    PyErr_SetObject(type.ptr(), error.ptr());
}

} // namespace

void refuse_new(const py::handle& type) {
    reinterpret_cast<PyTypeObject*>(type.ptr())->tp_new = [](PyTypeObject* of, PyObject*,
                                                             PyObject*) -> PyObject* {
        PyErr_Format(PyExc_TypeError, "%s objects are made by the library only", of->tp_name);
        return nullptr;
    };
}

void bind_errors(py::module_&) {
    py::register_exception_translator([](std::exception_ptr thrown) {
        try {
            if (thrown) {
                std::rethrow_exception(thrown);
            }
        } catch (const InputError& e) {
            const bool placed = !e.file().empty() && e.line() != 0;
            raise("InputError", py::str(e.problem()), text_or_none(e.instead()),
                  text_or_none(e.file()),
                  placed ? py::object(py::int_(e.line())) : py::object(py::none()));
        } catch (const UndecidedError& e) {
            raise("UndecidedError", py::str(e.what()), py::str(e.advice()));
        } catch (const DomainError& e) {
            raise("DomainError", py::str(e.what()));
        } catch (const BudgetError& e) {
            raise("BudgetError", py::str(e.what()), py::str("ask for fewer digits"));
        } catch (const Error& e) {
            raise("Error", py::str(e.what()));
        } catch (const Interrupted& e) {
            PyErr_SetString(PyExc_KeyboardInterrupt, e.what().c_str());
        }
    });
}

} // namespace edgeproof::python
