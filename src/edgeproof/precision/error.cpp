// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/precision/error.hpp"

#include <utility>

namespace edgeproof {
namespace {

std::string one_line(const std::string& file, std::size_t line, const std::string& problem,
                     const std::string& instead) {
    std::string text;
    if (!file.empty()) {
        text += file;
        if (line != 0) {
            text += ':' + std::to_string(line);
        }
        text += ": ";
    }
    text += problem;
    if (!instead.empty()) {
        text += "; " + instead;
    }
    // A stray newline in quoted input would break the promise of one line.
    for (char& c : text) {
        if (c == '\n' || c == '\r') {
            c = ' ';
        }
    }
    return text;
}

} // namespace

InputError::InputError(std::string problem, std::string instead)
    : InputError(std::string{}, 0, std::move(problem), std::move(instead)) {}

InputError::InputError(std::string file, std::size_t line, std::string problem, std::string instead)
    : Error(one_line(file, line, problem, instead)), file_(std::move(file)), line_(line),
      problem_(std::move(problem)), instead_(std::move(instead)) {}

InputError InputError::at(const std::string& file, std::size_t line) const {
    return {file, line, problem_, instead_};
}

} // namespace edgeproof
