// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/counts/counting.hpp"

#include "edgeproof/precision/error.hpp"

#include <fmt/format.h>

#include <sstream>

namespace edgeproof::validation {
namespace {

std::string head_of(const CountKind& kind, const CountState& s) {
    return fmt::format("edgeproof bounds {}, seed {}, values {}", kind.name, s.seed, s.values) +
           (kind.with_digits ? fmt::format(", digits {}", s.digits) : "");
}

/// Reads the line of a contact; returns false if it is malformed.
bool read_contact_line(const CountKind& kind, const std::string& line, CountState& state) {
    std::istringstream words(line);
    std::size_t contact = 0;
    if (!(words >> contact)) {
        return false;
    }
    CountCells& cells = state.contacts[contact];
    const std::size_t number_of_cells = kind.rows.size() * kind.columns.size();
    std::size_t first = 0;
    std::size_t second = 0;
    char colon = 0;
    while (words >> first) {
        if (!(words >> colon >> second) || colon != ':') {
            return false;
        }
        const std::size_t cell = kind.all_cells ? cells.size() : first;
        CountCell& found = cells[cell];
        found.values = kind.all_cells ? first : second;
        found.undecided = kind.all_cells ? second : 0;
        if (cell >= number_of_cells || found.values > kind.contact_values ||
            found.undecided > found.values) {
            return false;
        }
    }
    return words.eof() && total_of(cells).values <= kind.contact_values &&
           (!kind.all_cells || cells.size() == number_of_cells);
}

} // namespace

void CountCell::add(const CountCell& o) {
    values += o.values;
    excluded += o.excluded;
    wrong += o.wrong;
    wide += o.wide;
    undecided += o.undecided;
}

CountCell total_of(const CountCells& cells) {
    CountCell total;
    for (const auto& [cell, found] : cells) {
        total.add(found);
    }
    return total;
}

std::string write_count_state(const CountKind& kind, const CountState& state) {
    std::string text = head_of(kind, state) + "\n";
    for (const auto& [number, cells] : state.contacts) {
        const CountCell total = total_of(cells);
        if (total.failures() + (kind.all_cells ? 0 : total.undecided) > 0) {
            continue;
        }
        text += std::to_string(number);
        for (const auto& [cell, found] : cells) {
            text += kind.all_cells ? fmt::format(" {}:{}", found.values, found.undecided)
                                   : fmt::format(" {}:{}", cell, found.values);
        }
        text += "\n";
    }
    return text + "end\n";
}

CountState parse_count_state(const CountKind& kind, std::string_view text, const std::string& file,
                             const CountState& wanted) {
    CountState state = wanted;
    state.contacts.clear();
    std::istringstream in{std::string(text)};
    std::string line;
    std::size_t number = 1;
    const auto reject = [&](const std::string& problem) {
        throw InputError(problem, "remove the file to count from the start").at(file, number);
    };
    const std::string head = head_of(kind, wanted);
    if (!std::getline(in, line) || line != head) {
        reject("the state is not one of \"" + head + "\"");
    }
    while (++number, std::getline(in, line) && line != "end") {
        if (!read_contact_line(kind, line, state)) {
            reject("a contact's counts are malformed");
        }
    }
    if (line != "end") {
        reject("the state is incomplete");
    }
    return state;
}

} // namespace edgeproof::validation
