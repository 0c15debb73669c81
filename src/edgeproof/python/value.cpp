// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/edgeproof.hpp"
#include "edgeproof/python/bindings.hpp"

#include <pybind11/stl.h>

#include <functional>
#include <optional>

namespace py = pybind11;
using namespace py::literals;

namespace edgeproof::python {
namespace {

/// Returns the other side of an operator with a value; nothing if it is no number.
std::optional<Value> operand(const py::object& other, unsigned digits) {
    if (py::isinstance<Value>(other)) {
        return other.cast<Value>();
    }
    if (py::isinstance<py::str>(other) || py::isinstance<py::bytes>(other) ||
        (py::hasattr(other, "shape") && py::isinstance<py::tuple>(other.attr("shape")) &&
         py::len(other.attr("shape")) > 0)) {
        return {}; // numpy calls the operator for each element
    }
    try {
        const py::object text =
            py::module_::import("edgeproof._numbers").attr("exact_text")(other, "a number");
        return Value::given(text.cast<std::string>(), digits);
    } catch (py::error_already_set& error) {
        if (error.matches(PyExc_TypeError)) {
            return {};
        }
        throw;
    }
}

py::object not_implemented() { return py::reinterpret_borrow<py::object>(Py_NotImplemented); }

template <class Test> auto comparison(const Test& test) {
    return [test](const py::object& self, const py::object& other) -> py::object {
        if (self.is(other)) {
            return py::bool_(test(0, 0));
        }
        const auto& value = self.cast<const Value&>();
        const auto theirs = operand(other, value.digits);
        return theirs ? py::bool_(test(compared(value, *theirs), 0)) : not_implemented();
    };
}

/// The operator x op y of Python; `reflected`: the method belongs to y.
template <class Operation> auto arithmetic(const Operation& op, bool reflected = false) {
    return [op, reflected](const Value& self, const py::object& other) -> py::object {
        const auto theirs = operand(other, self.digits);
        return !theirs ? not_implemented()
                       : py::cast(reflected ? op(*theirs, self) : op(self, *theirs));
    };
}

/// Division by 0 is an error of Python.
Value quotient(const Value& x, const Value& y) {
    if (y.exact && y.text == "0") {
        PyErr_SetString(PyExc_ZeroDivisionError, "division by zero");
        throw py::error_already_set();
    }
    return x / y;
}

} // namespace

void bind_value(py::module_& module) {
    py::class_<Value> value(module, "Value"); // _value.py completes it
    value
        .def_readonly("text", &Value::text, "The value, rounded correctly to the requested digits.")
        .def_readonly("bound", &Value::bound,
                      "|text - exact| is at most this; two digits, rounded up.")
        .def_readonly("proved", &Value::proved,
                      "Whether the bound is proved; else it is an estimate.")
        .def_readonly("digits", &Value::digits, "The requested digits.")
        .def_readonly("complete", &Value::complete, "Whether .text has all the requested digits.")
        .def_readonly("_how", &Value::route)
        .def_readonly("_is_exact", &Value::exact)
        .def("_interval", &Value::interval)
        .def("_rounded", &Value::rounded)
        .def("_state", &Value::state)
        .def("__float__", &Value::nearest)
        .def("__bool__",
             [](const Value& v) { return compared(v, Value::given("0", v.digits)) != 0; })
        .def("__lt__", comparison(std::less<>()))
        .def("__le__", comparison(std::less_equal<>()))
        .def("__gt__", comparison(std::greater<>()))
        .def("__ge__", comparison(std::greater_equal<>()))
        .def("__eq__", comparison(std::equal_to<>()))
        .def("__ne__", comparison(std::not_equal_to<>()))
        .def("__add__", arithmetic(std::plus<>()))
        .def("__radd__", arithmetic(std::plus<>(), true))
        .def("__sub__", arithmetic(std::minus<>()))
        .def("__rsub__", arithmetic(std::minus<>(), true))
        .def("__mul__", arithmetic(std::multiplies<>()))
        .def("__rmul__", arithmetic(std::multiplies<>(), true))
        .def("__truediv__", arithmetic(quotient))
        .def("__rtruediv__", arithmetic(quotient, true))
        .def("__neg__", [](const Value& v) { return -v; })
        .def("__pos__", [](const Value& v) { return v; })
        .def("__abs__", [](const Value& v) { return abs(v); });
    refuse_new(value);
    value.attr("__hash__") = py::none(); // the bounds may not decide whether two values are equal
    value.attr("__module__") = "edgeproof";
    module.def("given", &Value::given, "text"_a, "digits"_a);
    module.def("value_of_state", &Value::from_state, "state"_a);
}

} // namespace edgeproof::python
