// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/error.hpp"
#include "edgeproof/scene/input/bounded_value.hpp"

#include <optional>
#include <string>
#include <utility>

namespace edgeproof::python {

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

/// Thrown if the bounds of the values do not answer a question.
class UndecidedError : public Error {
public:
    UndecidedError(const std::string& problem, std::string advice)
        : Error(problem), advice_(std::move(advice)) {}
    [[nodiscard]] const std::string& advice() const noexcept { return advice_; }

private:
    std::string advice_;
};

} // namespace edgeproof::python
