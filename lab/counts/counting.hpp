// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The common part of the counts of values: contacts are counted in parallel, and the state is
// stored occasionally, so that an interrupted count can continue.
#include "edgeproof/parallel/parallel_for.hpp"
#include "edgeproof/precision/interruption.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <map>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace edgeproof::validation {

/// The counts for the values of one cell of a table.
struct CountCell {
    std::size_t values = 0;
    std::size_t excluded = 0;  ///< the enclosure does not contain the value in Real
    std::size_t wrong = 0;     ///< a printed digit, or a binary64, is not correctly rounded
    std::size_t wide = 0;      ///< the enclosure is wider than 10 units of the last digit requested
    std::size_t undecided = 0; ///< no enclosure, or no second value, within the budgets

    [[nodiscard]] std::size_t failures() const { return excluded + wrong + wide; }
    void add(const CountCell& o);
};
using CountCells = std::map<std::size_t, CountCell>; ///< by row * columns + column

/// A kind of count: the rows and columns of its table, and how its state is stored.
struct CountKind {
    std::string name;
    bool with_digits; ///< the first line of a state has the number of digits
    std::vector<std::string_view> rows;
    std::vector<std::string_view> columns;
    std::size_t contact_values; ///< per contact; the last contact may have fewer
    /// Each contact has all cells, and the values left undecided are a result; else contacts with
    /// undecided values are counted again.
    bool all_cells;
};

/// The cells and the findings of one contact.
template <class Finding> struct CountedContact {
    CountCells cells;
    std::vector<Finding> findings;
};

/// The state of a count: the cells of the finished contacts.
struct CountState {
    std::uint64_t seed = 1;
    std::size_t values = 0;
    unsigned digits = 50;
    std::map<std::size_t, CountCells> contacts;
};

struct CountOptions {
    std::uint64_t seed = 1;
    std::size_t values = 100'000;
    unsigned digits = 50;
    unsigned threads = 0; ///< 0: as many as the machine has
    std::function<void(std::size_t, std::size_t)> progress = {};
    /// Called occasionally, and at the end, with the finished results, from one thread at a time.
    std::function<void(const CountState&)> checkpoint = {};
};

template <class Finding> struct CountResult {
    CountCells cells;
    CountCell total;
    std::size_t contacts = 0;
    std::vector<Finding> findings; ///< in the order of the contacts
};

[[nodiscard]] CountCell total_of(const CountCells& cells);

/// Counts the contacts missing in `state`. `count(number, values)` counts one contact; it is called
/// from several threads. Calls `options.progress` after each contact. Throws Interrupted after
/// storing the state, and as `count` does.
template <class Finding, class Count>
CountResult<Finding> count_contacts(const CountKind& kind, const CountOptions& options,
                                    CountState& state, const Count& count) {
    constexpr std::size_t contacts_between_checkpoints = 20;
    state.seed = options.seed;
    state.values = options.values;
    state.digits = options.digits;
    const auto size_of = [&](std::size_t number) {
        return std::min(kind.contact_values, options.values - number * kind.contact_values);
    };
    std::vector<std::size_t> left;
    std::size_t done = options.values;
    for (std::size_t number = 0; number * kind.contact_values < options.values; ++number) {
        if (!state.contacts.contains(number)) {
            left.push_back(number);
            done -= size_of(number);
        }
    }
    std::map<std::size_t, std::vector<Finding>> findings;
    std::mutex mutex;
    std::size_t since = 0;
    const auto keep = [&] {
        if (options.checkpoint) {
            options.checkpoint(state);
        }
    };
    const auto count_one = [&](std::size_t i) {
        const std::size_t number = left[i];
        CountedContact<Finding> found = count(number, size_of(number));
        const std::lock_guard lock(mutex);
        state.contacts[number] = std::move(found.cells);
        findings[number] = std::move(found.findings);
        done += size_of(number);
        if (options.progress) {
            options.progress(done, options.values);
        }
        if (++since == contacts_between_checkpoints) {
            since = 0;
            keep();
        }
    };
    try {
        parallel::work_through(parallel::all_pieces(left.size()), options.threads, count_one);
    } catch (const Interrupted&) {
        keep();
        throw Interrupted("interrupted after " + std::to_string(done) + " of " +
                          std::to_string(options.values) + " values");
    }
    keep();
    CountResult<Finding> result;
    result.contacts = state.contacts.size();
    for (const auto& [number, cells] : state.contacts) {
        for (const auto& [cell, found] : cells) {
            result.cells[cell].add(found);
        }
    }
    result.total = total_of(result.cells);
    for (auto& [number, list] : findings) {
        std::ranges::move(list, std::back_inserter(result.findings));
    }
    return result;
}

/// Writes the contacts without findings, one line each; those with findings are left out, so that
/// they are repeated.
[[nodiscard]] std::string write_count_state(const CountKind& kind, const CountState& state);
/// Throws InputError with the line for a text that is not such a state, or one of another kind,
/// seed, number of values or digits than `wanted`.
[[nodiscard]] CountState parse_count_state(const CountKind& kind, std::string_view text,
                                           const std::string& file, const CountState& wanted);

} // namespace edgeproof::validation
