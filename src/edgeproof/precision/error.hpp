// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <stdexcept>
#include <string>

namespace edgeproof {

/// The base class of all exceptions that the library throws on purpose.
class Error : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Malformed or inadmissible input. `what()` is the one line that a user reads: `FILE:LINE: what is
/// wrong; what to write instead` (without the place if there is none).
class InputError : public Error {
public:
    InputError(std::string problem, std::string instead);
    /// Returns the same error with the file and line (line 0: the file as a whole).
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

/// A value was requested outside the domain on which the mechanics defines it.
class DomainError : public Error {
public:
    using Error::Error;
};

/// A counted budget (evaluations or digits) was used up before the target was reached.
class BudgetError : public Error {
public:
    using Error::Error;
};

/// Throws InputError if a requirement on the input does not hold; `instead` states what to give.
inline void require(bool holds, const std::string& problem, const std::string& instead) {
    if (!holds) {
        throw InputError(problem, instead);
    }
}

} // namespace edgeproof
