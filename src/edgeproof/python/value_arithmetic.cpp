// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/precision/rounding/text.hpp"
#include "edgeproof/python/bindings.hpp"

#include <pybind11/stl.h>

#include <algorithm>
#include <utility>

namespace py = pybind11;

namespace edgeproof::python {
namespace {

enum class Operation { add, subtract, multiply, divide };

template <class T> T applied(Operation operation, const T& x, const T& y) {
    switch (operation) {
    case Operation::add:
        return T(x + y);
    case Operation::subtract:
        return T(x - y);
    case Operation::multiply:
        return T(x * y);
    case Operation::divide:
        break;
    }
    return T(x / y);
}

[[noreturn]] void refuse_division_by_zero() {
    PyErr_SetString(PyExc_ZeroDivisionError, "division by zero");
    throw py::error_already_set();
}

/// Longer exact numbers are kept as enclosures only: repeated products would fill the memory.
constexpr std::size_t most_bits_of_exact = 100'000;
/// Results are refused if their size is not between 2^-limit and 2^limit: their texts and exact
/// ends would be as long as this exponent.
constexpr long limit_of_exponent = 400'000;

bool is_short(const Rational& q) {
    return mpz_sizeinbase(numerator(q).backend().data(), 2) +
               mpz_sizeinbase(denominator(q).backend().data(), 2) <
           most_bits_of_exact;
}

void require_size(const Ball& x) {
    const Ball most = abs(x);
    static const Ball scale = pow_int(Ball(2, 64), limit_of_exponent);
    if (most.is_exact() && contains_zero(most)) {
        return;
    }
    if (!certainly_less(most, scale) || certainly_less(most, 1 / scale)) {
        throw InputError("the result is beyond the range of numbers",
                         "compute with numbers within 2^(+-" + std::to_string(limit_of_exponent) +
                             ")");
    }
}

/// Returns the digits of a result: those requested, or fewer if only these are certain, for example
/// after a difference of nearly equal values.
unsigned certain_digits(const Ball& x, unsigned digits) {
    constexpr unsigned fewest = 2;
    if (contains_zero(x)) {
        return digits;
    }
    const Rounded r = round_ball(x, digits);
    return r.complete ? digits : std::max(fewest, std::min(r.digits, digits));
}

/// Returns x op y in ball arithmetic: the enclosure of all results for numbers in the two balls.
Value computed(Operation operation, const scene::BoundedValue& x, const scene::BoundedValue& y,
               unsigned digits) {
    const long bits = std::max(x.value.bits(), y.value.bits());
    const auto ball = [bits](const scene::BoundedValue& v) {
        return v.exactly ? Ball(*v.exactly, bits) : v.value;
    };
    const Ball divisor = ball(y);
    if (operation == Operation::divide && contains_zero(divisor)) {
        if (divisor.is_exact()) {
            refuse_division_by_zero();
        }
        throw UndecidedError("the divisor may be zero", "ask for it with more digits");
    }
    scene::BoundedValue result{applied(operation, ball(x), divisor), x.proved && y.proved,
                               "arithmetic"};
    require_size(result.value);
    if (x.exactly && y.exactly) {
        Rational q = applied(operation, *x.exactly, *y.exactly);
        if (is_short(q)) {
            result.value = Ball(q, bits);
            result.exactly = std::move(q);
        }
    }
    if (!result.exactly) {
        digits = certain_digits(result.value, digits);
    }
    return {std::move(result), digits};
}

/// Returns the digits of a result: those of the values that are not exact, or else of both.
unsigned digits_of_result(const Value& x, const Value& y) {
    return x.value().exactly && !y.value().exactly   ? y.digits()
           : y.value().exactly && !x.value().exactly ? x.digits()
                                                     : std::min(x.digits(), y.digits());
}

/// The operator x op y of Python; `reflected`: the method belongs to y.
auto arithmetic(Operation operation, bool reflected) {
    return [operation, reflected](const Value& self, const py::object& other) -> py::object {
        const auto result = [&](const scene::BoundedValue& theirs, unsigned digits) {
            return py::cast(reflected ? computed(operation, theirs, self.value(), digits)
                                      : computed(operation, self.value(), theirs, digits));
        };
        if (py::isinstance<Value>(other)) {
            const auto& theirs = other.cast<const Value&>();
            return result(theirs.value(), digits_of_result(self, theirs));
        }
        const auto q = number_of(other);
        if (!q) {
            return py::reinterpret_borrow<py::object>(Py_NotImplemented);
        }
        return result({Ball(*q, self.value().value.bits()), true, "given", *q}, self.digits());
    };
}

Value negative(const Value& v) {
    scene::BoundedValue x = v.value();
    x.value = -x.value;
    if (x.exactly) {
        *x.exactly = Rational(-*x.exactly);
    }
    return {std::move(x), v.digits()};
}

Value absolute(const Value& v) {
    scene::BoundedValue x = v.value();
    x.value = abs(x.value);
    if (x.exactly) {
        *x.exactly = Rational(abs(*x.exactly));
    }
    return {std::move(x), v.digits()};
}

} // namespace

void bind_arithmetic(py::class_<Value>& value) {
    value.def("__add__", arithmetic(Operation::add, false))
        .def("__radd__", arithmetic(Operation::add, true))
        .def("__sub__", arithmetic(Operation::subtract, false))
        .def("__rsub__", arithmetic(Operation::subtract, true))
        .def("__mul__", arithmetic(Operation::multiply, false))
        .def("__rmul__", arithmetic(Operation::multiply, true))
        .def("__truediv__", arithmetic(Operation::divide, false))
        .def("__rtruediv__", arithmetic(Operation::divide, true))
        .def("__neg__", &negative)
        .def("__pos__", [](const Value& v) { return v; })
        .def("__abs__", &absolute);
}

} // namespace edgeproof::python
