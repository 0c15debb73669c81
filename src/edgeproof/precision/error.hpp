// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <stdexcept>
#include <string>

namespace edgeproof {

/// Every exception that the library throws on purpose derives from this one.
class Error : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Malformed or inadmissible input. `what()` is the one line a user reads:
/// `FILE:LINE: what is wrong; what to write instead` (the place is left out where there is none).
class InputError : public Error {
public:
    InputError(std::string problem, std::string instead);
    /// The same error, now that the file and line are known (line 0: the file as a whole).
    [[nodiscard]] InputError at(const std::string& file, std::size_t line) const;

    [[nodiscard]] const std::string& problem() const noexcept { return problem_; }
    [[nodiscard]] const std::string& instead() const noexcept { return instead_; }
    [[nodiscard]] const std::string& file() const noexcept { return file_; }
    [[nodiscard]] std::size_t line() const noexcept { return line_; }

private:
    InputError(std::string file, std::size_t line, std::string problem, std::string instead);
    std::string file_;
    std::size_t line_ = 0;
    std::string problem_;
    std::string instead_;
};

/// A value was asked for outside the domain on which the mechanics defines it.
class DomainError : public Error {
public:
    using Error::Error;
};

/// A counted budget (evaluations or digits) ran out before the target was reached; never silent.
class BudgetError : public Error {
public:
    using Error::Error;
};

} // namespace edgeproof
