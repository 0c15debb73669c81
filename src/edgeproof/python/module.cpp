// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/edgeproof.hpp"
#include "edgeproof/python/bindings.hpp"
#include "edgeproof/python/without_gil.hpp"

#include <pybind11/stl.h>

#include <exception>

namespace py = pybind11;
using namespace py::literals;

namespace edgeproof::python {
namespace {

py::object text_or_none(const std::string& text) {
    return text.empty() ? py::object(py::none()) : py::object(py::str(text));
}

void raise(const char* kind, const py::object& problem, const py::object& advice = py::none(),
           const py::object& file = py::none(), const py::object& line = py::none()) {
    const py::object type = py::module_::import("edgeproof.errors").attr(kind);
    const py::object error = type(problem, advice, file, line);
    PyErr_SetObject(type.ptr(), error.ptr());
}

void translate(std::exception_ptr thrown) {
    try {
        if (thrown) {
            std::rethrow_exception(thrown);
        }
    } catch (const InputError& e) {
        const bool placed = !e.file().empty() && e.line() != 0;
        raise("InputError", py::str(e.problem()), text_or_none(e.instead()), text_or_none(e.file()),
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
}

/// Returns the function of Python, whose first argument is called with the progress (or is None).
template <class Result, class... Arguments>
auto with_callback(Result (*function)(const Progress&, Arguments...)) {
    return [function](py::object callback, Arguments... arguments) {
        return with_progress(std::move(callback), [&](const Progress& progress) {
            return function(progress, arguments...);
        });
    };
}

} // namespace

void refuse_new(const py::handle& type) {
    reinterpret_cast<PyTypeObject*>(type.ptr())->tp_new = [](PyTypeObject* of, PyObject*,
                                                             PyObject*) -> PyObject* {
        PyErr_Format(PyExc_TypeError, "%s objects are made by the library only", of->tp_name);
        return nullptr;
    };
}

} // namespace edgeproof::python

PYBIND11_MODULE(_edgeproof, module) {
    using namespace edgeproof;
    module.doc() = "The compiled part of edgeproof; use the package edgeproof.";
    module.attr("__version__") = EDGEPROOF_VERSION;
    py::register_exception_translator(python::translate);
    python::bind_value(module);
    python::bind_scene(module);
    py::class_<Outcome>(module, "Outcome")
        .def_readonly("text", &Outcome::text)
        .def_readonly("json", &Outcome::json);
    module.def("read_text", &json::read_text, "file"_a, "what"_a);
    module.def("verify", python::with_callback(&json::verify), "progress"_a, "ledger"_a, "digits"_a,
               "only"_a, "threads"_a);
    module.def("questions", python::apart(&json::questions), "recipe"_a);
    module.def("check", python::with_callback(&json::check), "progress"_a, "options"_a);
    module.def("compare", python::with_callback(&json::compare), "progress"_a, "scene"_a, "name"_a,
               "results"_a, "options"_a);
    module.def("design", python::with_callback(&json::design), "progress"_a, "text"_a, "file"_a,
               "options"_a);
    module.def("relations", python::apart(&json::relations), "quantities"_a, "degree"_a,
               "symmetric"_a, "given"_a, "free"_a);
}
