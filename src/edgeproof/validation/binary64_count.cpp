// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/validation/binary64_count.hpp"

#include "edgeproof/parallel/parallel_for.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/validation/state_text.hpp"

#include <mutex>
#include <sstream>

namespace edgeproof::validation {
namespace {

constexpr std::size_t contacts_between_checkpoints = 20;

std::string head(const Binary64State& s) {
    return "edgeproof bounds binary64, seed " + std::to_string(s.seed) + ", values " +
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
    const std::vector<std::size_t> left = contacts_left(sizes.contacts(), state.contacts);
    std::size_t done = sizes.but(left);
    std::map<std::size_t, std::vector<std::string>> findings;
    std::mutex mutex;
    std::size_t since = 0;
    try {
        parallel::work_through(
            parallel::all_pieces(left.size()), options.threads, [&](std::size_t i) {
                const std::size_t number = left[i];
                Binary64Contact found = count_binary64_contact(options, number, sizes.of(number));
                const std::lock_guard lock(mutex);
                state.contacts[number] = found.cells;
                findings[number] = std::move(found.findings);
                done += sizes.of(number);
                if (options.progress) {
                    options.progress(done, options.values);
                }
                if (options.checkpoint && ++since == contacts_between_checkpoints) {
                    since = 0;
                    options.checkpoint(state);
                }
            });
    } catch (const Interrupted&) {
        if (options.checkpoint) {
            options.checkpoint(state);
        }
        throw Interrupted("interrupted after " + std::to_string(done) + " of " +
                          std::to_string(options.values) + " values");
    }
    if (options.checkpoint) {
        options.checkpoint(state);
    }
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
    for (auto& [number, list] : findings) {
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
