// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/counts/binary64_count.hpp"

#include "lab/counts/state_text.hpp"

#include <sstream>

namespace edgeproof::validation {
namespace {

std::string head(const Binary64State& s) {
    // The draw number changes when the same seed draws other values.
    return "edgeproof bounds binary64, draw 2, seed " + std::to_string(s.seed) + ", values " +
           std::to_string(s.values);
}

Binary64Cell total_of(const Binary64Cells& cells) {
    Binary64Cell total;
    for (const auto& row : cells) {
        for (const Binary64Cell& cell : row) {
            total.add(cell);
        }
    }
    return total;
}

} // namespace

void Binary64Cell::add(const Binary64Cell& o) {
    values += o.values;
    undecided += o.undecided;
    wrong += o.wrong;
}

Binary64Count count_binary64(const Binary64Options& options, Binary64State& state) {
    state.seed = options.seed;
    state.values = options.values;
    const ContactSizes sizes{options.values, places_a_contact};
    const auto findings = count_contacts_left<std::string>(
        options, state, sizes, [&options](std::size_t number, std::size_t values) {
            return count_binary64_contact(options, number, values);
        });
    Binary64Count count;
    count.contacts = state.contacts.size();
    for (const auto& [number, cells] : state.contacts) {
        for (std::size_t f = 0; f < cells.size(); ++f) {
            for (std::size_t p = 0; p < cells[f].size(); ++p) {
                count.cells[f][p].add(cells[f][p]);
            }
        }
    }
    count.total = total_of(count.cells);
    for (const auto& [number, list] : findings) {
        count.findings.insert(count.findings.end(), list.begin(), list.end());
    }
    return count;
}

std::string write_binary64_state(const Binary64State& state) {
    std::string text = head(state) + "\n";
    for (const auto& [number, cells] : state.contacts) {
        if (total_of(cells).wrong > 0) {
            continue;
        }
        text += std::to_string(number);
        for (const auto& row : cells) {
            for (const Binary64Cell& cell : row) {
                text += " " + std::to_string(cell.values) + ":" + std::to_string(cell.undecided);
            }
        }
        text += "\n";
    }
    return text + "end\n";
}

Binary64State parse_binary64_state(std::string_view text, const std::string& file,
                                   const Binary64State& wanted) {
    Binary64State state = wanted;
    state.contacts.clear();
    read_state_text(text, file, head(wanted), [&](const std::string& line) {
        std::istringstream words(line);
        std::size_t contact = 0;
        Binary64Cells cells{};
        char colon = 0;
        bool good = static_cast<bool>(words >> contact);
        for (auto& row : cells) {
            for (Binary64Cell& cell : row) {
                good = good && (words >> cell.values >> colon >> cell.undecided) && colon == ':' &&
                       cell.undecided <= cell.values;
            }
        }
        state.contacts[contact] = cells;
        return good && !(words >> colon) && total_of(cells).values <= places_a_contact;
    });
    return state;
}

} // namespace edgeproof::validation
