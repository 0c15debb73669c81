// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The common part of the counts of values: contacts are counted in parallel.
#include "edgeproof/parallel/parallel_for.hpp"
#include "edgeproof/report/tables/table.hpp"

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
    void add(const CountCell& o) {
        values += o.values;
        excluded += o.excluded;
        wrong += o.wrong;
        wide += o.wide;
        undecided += o.undecided;
    }
};
using CountCells = std::map<std::size_t, CountCell>; ///< by row * columns + column

/// The cells and the findings of one contact.
template <class Finding> struct CountedContact {
    CountCells cells;
    std::vector<Finding> findings;
};

struct CountOptions {
    std::uint64_t seed = 1;
    std::size_t values = 100'000;
    unsigned digits = 50;
    unsigned threads = 0; ///< 0: as many as the machine has
    std::function<void(std::size_t, std::size_t)> progress = {};
};

template <class Finding> struct CountResult {
    CountCells cells;
    CountCell total;
    std::size_t contacts = 0;
    std::vector<Finding> findings; ///< in the order of the contacts
};

/// Counts contacts of `contact_values` values each; the last one may have fewer. `count(number,
/// values)` counts one contact; it is called from several threads. Throws as `count` does.
template <class Finding, class Count>
CountResult<Finding> count_contacts(std::size_t contact_values, const CountOptions& options,
                                    const Count& count) {
    CountResult<Finding> result;
    result.contacts = (options.values + contact_values - 1) / contact_values;
    std::map<std::size_t, std::vector<Finding>> findings;
    std::mutex mutex;
    const auto count_one = [&](std::size_t number) {
        const std::size_t values =
            std::min(contact_values, options.values - number * contact_values);
        CountedContact<Finding> found = count(number, values);
        const std::lock_guard lock(mutex);
        for (const auto& [cell, counted] : found.cells) {
            result.cells[cell].add(counted);
            result.total.add(counted);
        }
        findings[number] = std::move(found.findings);
        if (options.progress) {
            options.progress(result.total.values, options.values);
        }
    };
    parallel::work_through(parallel::all_pieces(result.contacts), options.threads, count_one);
    for (auto& [number, list] : findings) {
        std::ranges::move(list, std::back_inserter(result.findings));
    }
    return result;
}

/// The names of two columns, and the rows and columns whose names stand in them.
struct CountNames {
    std::string_view row;
    std::string_view column;
    std::vector<std::string_view> rows;
    std::vector<std::string_view> columns;
};
/// Adds the names of each cell and its counts, and the total.
void add_counts(report::Table& table, const CountNames& names,
                const std::vector<std::pair<const char*, std::size_t CountCell::*>>& counts,
                const CountCells& cells, const CountCell& total);

} // namespace edgeproof::validation
