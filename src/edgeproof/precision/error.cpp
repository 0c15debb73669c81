// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/precision/error.hpp"

#include "edgeproof/precision/message.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

namespace edgeproof {
namespace {

constexpr std::size_t most_bytes = 600; ///< of the problem, and of the text after it

constexpr std::size_t most_bytes_of_name = 300; ///< of a file
constexpr std::size_t most_bytes_of_word = 200; ///< of a number, a name or a path that is quoted

/// The text with the middle of each longer word left out.
std::string with_short_words(const std::string& text) {
    std::string all;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find(' ', at), text.size());
        all += shortened(std::string_view(text).substr(at, end - at), most_bytes_of_word);
        all += end < text.size() ? " " : "";
        at = end + 1;
    }
    return all;
}

std::string one_line(const std::string& file, std::size_t line, const std::string& problem,
                     const std::string& instead) {
    std::string text;
    if (!file.empty()) {
        text += shortened(file, most_bytes_of_name);
        if (line != 0) {
            text += ':' + std::to_string(line);
        }
        text += ": ";
    }
    text += shortened(with_short_words(problem), most_bytes);
    if (!instead.empty()) {
        text += "; " + shortened(with_short_words(instead), most_bytes);
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
