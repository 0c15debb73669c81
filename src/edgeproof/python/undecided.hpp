// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/error.hpp"

#include <string>
#include <utility>

namespace edgeproof::python {

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
