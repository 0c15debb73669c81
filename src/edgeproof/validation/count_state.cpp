// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/validation/count_state.hpp"

#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <sstream>

namespace edgeproof::validation {
namespace {

std::string head(const CountState& s) {
    return "edgeproof bounds count, seed " + std::to_string(s.seed) + ", values " +
           std::to_string(s.values) + ", digits " + std::to_string(s.digits);
}

} // namespace

std::string write_count_state(const CountState& state) {
    std::string text = head(state) + "\n";
    for (const auto& [number, cells] : state.contacts) {
        const bool clean = std::all_of(cells.begin(), cells.end(), [](const auto& cell) {
            return cell.second.failures() + cell.second.undecided == 0;
        });
        if (!clean) {
            continue;
        }
        text += std::to_string(number);
        for (const auto& [cell, found] : cells) {
            text += " " + std::to_string(cell) + ":" + std::to_string(found.values);
        }
        text += "\n";
    }
    return text + "end\n";
}

CountState parse_count_state(std::string_view text, const std::string& file,
                             const CountState& wanted) {
    std::istringstream in{std::string(text)};
    std::string line;
    std::size_t number = 1;
    const auto reject = [&](const std::string& problem) {
        throw InputError(problem, "remove the file to count from the start").at(file, number);
    };
    if (!std::getline(in, line) || line != head(wanted)) {
        reject("the state is not one of \"" + head(wanted) + "\"");
    }
    CountState state = wanted;
    state.contacts.clear();
    while (++number, std::getline(in, line) && line != "end") {
        std::istringstream words(line);
        std::size_t contact = 0;
        if (!(words >> contact)) {
            reject("there is no number of a contact");
        }
        auto& cells = state.contacts[contact];
        std::size_t cell = 0;
        std::size_t values = 0;
        char colon = 0;
        while (words >> cell) {
            if (!(words >> colon >> values) || colon != ':' || values > values_a_contact ||
                cell >= sampled_profiles.size() * sampled_regimes.size()) {
                reject("a contact's counts are malformed");
            }
            cells[cell].values = values;
        }
        if (!words.eof()) {
            reject("a contact's counts are malformed");
        }
    }
    if (line != "end") {
        reject("the state ends in the middle");
    }
    return state;
}

} // namespace edgeproof::validation
