// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/precision/rounding/text.hpp"
#include "edgeproof/python/bindings.hpp"

#include <pybind11/operators.h>
#include <pybind11/stl.h>

#include <flint/flint.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <utility>

namespace py = pybind11;
using namespace py::literals;

namespace edgeproof::python {
namespace {

constexpr long most_digits = 100'000;

/// Converts by hexadecimal digits, because Python refuses to read decimal numbers of more than 4300
/// digits.
py::object integer_of(const Integer& n) {
    const std::unique_ptr<char, void (*)(void*)> hex(mpz_get_str(nullptr, 16, n.backend().data()),
                                                     [](void* text) { std::free(text); });
    return py::module_::import("builtins").attr("int")(hex.get(), 16);
}

py::object fraction_of(const Rational& q) {
    return py::module_::import("fractions")
        .attr("Fraction")(integer_of(numerator(q)), integer_of(denominator(q)));
}

Rational rational_of_real(const Real& x) {
    Rational q;
    mpfr_get_q(q.backend().data(), x.backend().data());
    return q;
}

/// Returns both ends of the value's enclosure, exactly.
std::pair<Rational, Rational> ends(const Value& v) {
    if (v.value().exactly) {
        return {*v.value().exactly, *v.value().exactly};
    }
    const Rational middle = rational_of_real(v.value().value.midpoint());
    const Rational radius = rational_of_real(v.value().value.radius());
    return {middle - radius, middle + radius};
}

[[noreturn]] void refuse_comparison() {
    throw UndecidedError("the bounds of the two values overlap", "ask for both with more digits");
}

/// Returns -1, 0 or 1.
int compared(const std::pair<Rational, Rational>& x, const std::pair<Rational, Rational>& y) {
    if (x.second < y.first) {
        return -1;
    }
    if (y.second < x.first) {
        return 1;
    }
    if (x.first == x.second && y.first == y.second) {
        return 0;
    }
    refuse_comparison();
}

/// Returns the ends of the other side of a comparison; no value if it is not a number.
std::optional<std::pair<Rational, Rational>> ends_of(const py::object& other) {
    if (py::isinstance<Value>(other)) {
        return ends(other.cast<const Value&>());
    }
    const auto q = number_of(other);
    return q ? std::optional(std::pair{*q, *q}) : std::nullopt;
}

template <class Test> auto comparison(const Test& test) {
    return [test](const py::object& self, const py::object& other) -> py::object {
        if (self.is(other)) {
            return py::bool_(test(0));
        }
        const auto theirs = ends_of(other);
        if (!theirs) {
            return py::reinterpret_borrow<py::object>(Py_NotImplemented);
        }
        return py::bool_(test(compared(ends(self.cast<const Value&>()), *theirs)));
    };
}

/// Returns the number in the value's text. Throws UndecidedError if the text contains two.
std::string one_number(const Value& v) {
    if (v.printed().text.empty() || v.printed().text.front() == '[') {
        throw UndecidedError("the rounding of the value is undecided: " + v.printed().text,
                             "take .interval(), or ask for more digits");
    }
    return v.printed().text;
}

std::string dumped(const Ball& x) {
    const std::unique_ptr<char, void (*)(void*)> text(arb_dump_str(x.data()), flint_free);
    return text.get();
}

Ball loaded(const std::string& text, long bits) {
    Ball x(0, bits);
    require(arb_load_str(x.data(), text.c_str()) == 0, "this is not a pickled Value", "");
    return x;
}

py::tuple state_of(const Value& v) {
    const auto& exactly = v.value().exactly;
    return py::make_tuple(
        dumped(v.value().value), v.value().value.bits(), v.value().proved, v.value().route,
        exactly ? py::object(py::str(exactly->str())) : py::object(py::none()), v.digits());
}

/// The inverse of state_of(); pickle calls it.
Value from_state(const py::tuple& state) {
    require(state.size() == 6, "this is not a pickled Value", "");
    scene::BoundedValue value{loaded(state[0].cast<std::string>(), state[1].cast<long>()),
                              state[2].cast<bool>(), state[3].cast<std::string>()};
    if (!state[4].is_none()) {
        value.exactly = parse_decimal(state[4].cast<std::string>());
    }
    return {std::move(value), state[5].cast<unsigned>()};
}

/// Returns the text with its first digits only, followed by "...", if it is long.
std::string shortened(const std::string& text) {
    constexpr std::size_t most_characters = 30;
    if (text.size() <= most_characters || text.front() == '[') {
        return text;
    }
    const std::size_t power = text.find('e');
    const std::string tail = power == std::string::npos ? "" : text.substr(power);
    const std::size_t dot = text.find('.');
    if (dot == std::string::npos || dot > most_characters) {
        return text; // a whole number
    }
    return text.substr(0, std::min(most_characters - 4, power)) + "..." + tail;
}

/// Returns "bound 1e-50, closed-form", or "exact, given".
std::string accuracy(const Value& v) {
    const std::string route = how(v.value(), v.printed());
    if (v.value().exactly && v.printed().bound == "0") {
        return "exact, " + route;
    }
    return (v.value().proved ? "bound " : "estimated bound ") + v.printed().bound + ", " + route;
}

std::string shown(const Value& v) {
    const std::string text = shortened(v.printed().text);
    const std::string digits =
        text == v.printed().text ? "" : " (" + std::to_string(v.digits()) + " digits)";
    return "<edgeproof.Value " + text + digits + ", " + accuracy(v) + ">";
}

/// Returns a module that may not have been imported.
py::object imported(const char* name) {
    return py::module_::import("edgeproof._lazy").attr("imported")(name);
}

/// Returns the value for a notebook: the text, and the whole of it where it is shortened.
std::string html(const Value& v) {
    const py::object escape = imported("html").attr("escape");
    const auto escaped = [&](const std::string& text) { return escape(text).cast<std::string>(); };
    return "<span title=\"" + escaped(v.printed().text) + "\"><code>" +
           escaped(shortened(v.printed().text)) + "</code> (" + escaped(accuracy(v)) + ")</span>";
}

py::object mpmath_of(const Value& v) {
    const Rational q = parse_decimal(one_number(v));
    const py::object mpmath = imported("mpmath");
    const py::object scope = mpmath.attr("workdps")(v.digits() + 5);
    scope.attr("__enter__")();
    py::object number = mpmath.attr("fdiv")(integer_of(numerator(q)), integer_of(denominator(q)));
    scope.attr("__exit__")(py::none(), py::none(), py::none());
    return number;
}

} // namespace

std::optional<Rational> number_of(const py::object& other) {
    if (py::isinstance<py::str>(other) || py::isinstance<py::bytes>(other) ||
        (py::hasattr(other, "shape") && py::isinstance<py::tuple>(other.attr("shape")) &&
         py::len(other.attr("shape")) > 0)) {
        return {}; // numpy calls the operator for each element
    }
    try {
        const py::object text =
            py::module_::import("edgeproof._numbers").attr("exact_text")(other, "a number");
        return parse_decimal(text.cast<std::string>());
    } catch (py::error_already_set& error) {
        if (error.matches(PyExc_TypeError)) {
            return {};
        }
        throw;
    }
}

scene::Digits digits_asked(unsigned count) { return {count, Rounding::nearest, true}; }

unsigned checked_digits(long count) {
    require(count >= 2 && count <= most_digits,
            "digits = " + std::to_string(count) + " is out of range",
            "give a number from 2 to " + std::to_string(most_digits));
    return static_cast<unsigned>(count);
}

Value::Value(scene::BoundedValue value, unsigned digits)
    : value_(std::move(value)), digits_(digits) {
    if (!value_.exactly && !value_.value.is_finite()) {
        throw BudgetError("no number of bits tried gives a value");
    }
    printed_ = scene::printed(value_, digits_asked(digits_));
}

double Value::nearest() const {
    if (!printed_.binary64) {
        throw UndecidedError("two binary64 may be the nearest one", "ask for more digits");
    }
    return *printed_.binary64 + 0.0; // no negative zero
}

void bind_value(py::module_& module) {
    py::class_<Value> value(module, "Value", R"(A computed number with how far it is to be trusted.

    text     the value, rounded correctly to the requested digits (or to those that are certain;
             one of two neighbours where the rounding of a proved value is undecided)
    bound    text: |text - exact| is at most this
    proved   True: the bound is proved. False: it is what the route estimates of itself
    route    how the value was computed: "closed-form", "series", "given", ...
    digits   the requested digits
    exact    fractions.Fraction where the value is known to be that rational number, else None

float(v) is the binary64 nearest to the exact value. v.fraction(), v.decimal() and v.mpmath() are
the number that .text states, exactly; v.interval() is what encloses the exact value. Comparisons
(with values and with int, float, Fraction, Decimal, mpmath.mpf, exactly) raise UndecidedError where
the bounds overlap, so that an answer is certain as far as the bounds are.

x + y, x - y, x*y, x/y, -x and abs(x) are Values with bounds, computed in ball arithmetic from the
enclosures of x and y; x or y may be a number, which is exact. The result is proved if both are. It
has the digits of the less precise of the two, or fewer if only these are certain. The operands are
treated as independent: x - x is an enclosure of 0, not 0. Raises ZeroDivisionError for the divisor
0, UndecidedError for one that may be 0.)");
    value
        .def_property_readonly(
            "text", [](const Value& v) { return v.printed().text; },
            "The value, rounded correctly to the requested digits.")
        .def_property_readonly(
            "bound", [](const Value& v) { return v.printed().bound; },
            "|text - exact| is at most this; two digits, rounded up.")
        .def_property_readonly(
            "proved", [](const Value& v) { return v.value().proved; },
            "Whether the bound is proved; else it is an estimate.")
        .def_property_readonly(
            "route", [](const Value& v) { return v.value().route; }, "How it was computed.")
        .def_property_readonly("digits", &Value::digits, "The requested digits.")
        .def_property_readonly(
            "complete", [](const Value& v) { return v.printed().complete; },
            "Whether .text has all the requested digits.")
        .def_property_readonly(
            "exact",
            [](const Value& v) {
                return v.value().exactly ? fraction_of(*v.value().exactly) : py::object(py::none());
            },
            "The value as a Fraction where it is known to be rational, else None.")
        .def(
            "interval",
            [](const Value& v) {
                const auto [low, high] = ends(v);
                return py::make_tuple(fraction_of(low), fraction_of(high));
            },
            "interval()\n\n(lower, upper): Fractions with the exact value between them (proved, or "
            "estimated).")
        .def(
            "rounded",
            [](const Value& v, long digits) {
                return scene::printed(v.value(), digits_asked(checked_digits(digits))).text;
            },
            "digits"_a,
            "rounded(digits)\n\nThe text at another number of digits, rounded from the value "
            "itself.")
        .def(
            "fraction", [](const Value& v) { return fraction_of(parse_decimal(one_number(v))); },
            "fraction()\n\nThe number that .text states, as fractions.Fraction.")
        .def(
            "decimal",
            [](const Value& v) {
                return py::module_::import("decimal").attr("Decimal")(one_number(v));
            },
            "decimal()\n\nThe number that .text states, as decimal.Decimal.")
        .def("mpmath", &mpmath_of,
             "mpmath()\n\nThe number that .text states, as mpmath.mpf with a few digits to spare.")
        .def("_mpmath_", [](const Value& v, const py::args&) { return mpmath_of(v); })
        .def("__float__", &Value::nearest)
        .def("__str__", [](const Value& v) { return v.printed().text; })
        .def("__repr__", &shown)
        .def("_repr_html_", &html)
        .def("__format__",
             [](const Value& v, const std::string& spec) {
                 return spec.empty()
                            ? py::str(v.printed().text)
                            : py::str(py::module_::import("builtins")
                                          .attr("format")(py::module_::import("decimal").attr(
                                                              "Decimal")(one_number(v)),
                                                          spec));
             })
        .def("__bool__",
             [](const Value& v) {
                 const Rational zero = 0;
                 return compared(ends(v), {zero, zero}) != 0;
             })
        .def("__lt__", comparison([](int c) { return c < 0; }))
        .def("__le__", comparison([](int c) { return c <= 0; }))
        .def("__gt__", comparison([](int c) { return c > 0; }))
        .def("__ge__", comparison([](int c) { return c >= 0; }))
        .def("__eq__", comparison([](int c) { return c == 0; }))
        .def("__ne__", comparison([](int c) { return c != 0; }))
        .def(
            "to_dict",
            [](const Value& v) {
                return py::dict("text"_a = v.printed().text, "bound"_a = v.printed().bound,
                                "proved"_a = v.value().proved, "route"_a = v.value().route);
            },
            "to_dict()\n\n{\"text\", \"bound\", \"proved\", \"route\"}.")
        .def("__reduce__", [](const Value& v) {
            return py::make_tuple(py::module_::import("edgeproof._value").attr("restored"),
                                  state_of(v));
        });
    module.def("value_of_state", &from_state, "state"_a);
    refuse_new(value);
    bind_arithmetic(value);
    value.attr("__hash__") = py::none(); // the bounds may not decide whether two values are equal
    value.attr("__module__") = "edgeproof";
}

} // namespace edgeproof::python
