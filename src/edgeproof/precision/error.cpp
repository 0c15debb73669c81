// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/precision/error.hpp"

#include "edgeproof/precision/message.hpp"

#include <utility>

namespace edgeproof {
namespace {

constexpr std::size_t most_bytes = 600; ///< of the problem, and of the text after it

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
    text += shortened(problem, most_bytes);
    if (!instead.empty()) {
        text += "; " + shortened(instead, most_bytes);
    }
    text = printable(text); // one line, without line breaks from the input
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
