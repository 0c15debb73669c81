// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/validation/counts/count_state.hpp"

#include "edgeproof/validation/counts/state_text.hpp"

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
    CountState state = wanted;
    state.contacts.clear();
    read_state_text(text, file, head(wanted), [&](const std::string& line) {
        std::istringstream words(line);
        std::size_t contact = 0;
        if (!(words >> contact)) {
            return false;
        }
        auto& cells = state.contacts[contact];
        std::size_t cell = 0;
        std::size_t values = 0;
        char colon = 0;
        while (words >> cell) {
            if (!(words >> colon >> values) || colon != ':' || values > values_a_contact ||
                cell >= sampled_profiles.size() * sampled_regimes.size()) {
                return false;
            }
            cells[cell].values = values;
        }
        return words.eof();
    });
    return state;
}

} // namespace edgeproof::validation
