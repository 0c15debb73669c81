// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/error.hpp"
#include "edgeproof/scene/input/bounded_value.hpp"

#include <pybind11/pybind11.h>

#include <optional>
#include <string>
#include <utility>

/// The Python module: the library's values, scenes, audits and conformance checks as Python
/// objects. It computes nothing itself. Each part has one function, which adds it:
///   module.cpp   the library's exceptions as those of edgeproof.errors
///   value.cpp, value_arithmetic.cpp  Value
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

/// edgeproof.Value: a value of the library with the digits for which it was computed.
class Value {
public:
    /// Throws BudgetError for a ball that is not finite: a value is never NaN.
    Value(scene::BoundedValue value, unsigned digits);

    [[nodiscard]] const scene::BoundedValue& value() const noexcept { return value_; }
    [[nodiscard]] unsigned digits() const noexcept { return digits_; }
    [[nodiscard]] const scene::PrintedValue& printed() const noexcept { return printed_; }
    /// Throws UndecidedError if several binary64 may be the nearest.
    [[nodiscard]] double nearest() const;

private:
    scene::BoundedValue value_;
    unsigned digits_;
    scene::PrintedValue printed_;
};

/// Returns the digits with which values are computed, including the bits that a binary64 needs.
[[nodiscard]] scene::Digits digits_asked(unsigned count);

/// Throws DomainError outside 2 ... 100,000.
[[nodiscard]] unsigned checked_digits(long count);

/// Returns the exact value of a Python number; nothing for anything else.
[[nodiscard]] std::optional<Rational> number_of(const pybind11::object& other);

/// Thrown if the bounds of the values do not answer a question.
class UndecidedError : public Error {
public:
    UndecidedError(const std::string& problem, std::string advice)
        : Error(problem), advice_(std::move(advice)) {}
    [[nodiscard]] const std::string& advice() const noexcept { return advice_; }

private:
    std::string advice_;
};

/// Makes T.__new__(T) a TypeError: the object would have no value.
void refuse_new(const pybind11::handle& type);

void bind_errors(pybind11::module_& module);
void bind_value(pybind11::module_& module);
/// Adds + - * /, the sign and abs() of values.
void bind_arithmetic(pybind11::class_<Value>& value);
void bind_scene(pybind11::module_& module);
void bind_audit(pybind11::module_& module);
void bind_check(pybind11::module_& module);
void bind_compare(pybind11::module_& module);
void bind_design(pybind11::module_& module);
void bind_relations(pybind11::module_& module);

} // namespace edgeproof::python
