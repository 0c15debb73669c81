// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/counts/state_text.hpp"

#include "edgeproof/precision/error.hpp"

#include <sstream>

namespace edgeproof::validation {

void read_state_text(std::string_view text, const std::string& file, const std::string& head,
                     const std::function<bool(const std::string&)>& read) {
    std::istringstream in{std::string(text)};
    std::string line;
    std::size_t number = 1;
    const auto reject = [&](const std::string& problem) {
        throw InputError(problem, "remove the file to count from the start").at(file, number);
    };
    if (!std::getline(in, line) || line != head) {
        reject("the state is not one of \"" + head + "\"");
    }
    while (++number, std::getline(in, line) && line != "end") {
        if (!read(line)) {
            reject("a contact's counts are malformed");
        }
    }
    if (line != "end") {
        reject("the state is incomplete");
    }
}

} // namespace edgeproof::validation
