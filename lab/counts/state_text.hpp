// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The common part of the counts of values: contacts are counted in parallel, and the state is
// stored occasionally, so that an interrupted count can continue.
#include "edgeproof/parallel/parallel_for.hpp"
#include "edgeproof/precision/interruption.hpp"

#include <cstddef>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace edgeproof::validation {

/// Reads the state of a count: the line `head`, then one line per contact, then "end". `read` is
/// called with each line and returns true if it is well formed; otherwise throws InputError with
/// the line.
void read_state_text(std::string_view text, const std::string& file, const std::string& head,
                     const std::function<bool(const std::string&)>& read);

/// Returns those of the contacts 0 ... n - 1 that are missing in a state.
template <class Found>
[[nodiscard]] std::vector<std::size_t> contacts_left(std::size_t n,
                                                     const std::map<std::size_t, Found>& contacts) {
    std::vector<std::size_t> left;
    for (std::size_t i = 0; i < n; ++i) {
        if (!contacts.contains(i)) {
            left.push_back(i);
        }
    }
    return left;
}

/// `values` divided into contacts of `each` values; the last one may have fewer.
struct ContactSizes {
    std::size_t values;
    std::size_t each;
    [[nodiscard]] std::size_t contacts() const { return (values + each - 1) / each; }
    [[nodiscard]] std::size_t of(std::size_t number) const {
        return number + 1 < contacts() ? each : values - number * each;
    }
    /// The number of values without those contacts.
    [[nodiscard]] std::size_t but(const std::vector<std::size_t>& left) const {
        std::size_t sum = values;
        for (const std::size_t number : left) {
            sum -= of(number);
        }
        return sum;
    }
};

/// Counts the contacts missing in `state.contacts`. `count(number, values)` counts one contact and
/// returns its cells and findings; it is called from several threads. Calls `options.progress`
/// after each contact and `options.checkpoint` after some and at the end. Returns the findings by
/// contact. Throws Interrupted after storing the state, and as `count` does.
template <class Finding, class Options, class State, class Count>
std::map<std::size_t, std::vector<Finding>>
count_contacts_left(const Options& options, State& state, const ContactSizes& sizes,
                    const Count& count) {
    constexpr std::size_t contacts_between_checkpoints = 20;
    const std::vector<std::size_t> left = contacts_left(sizes.contacts(), state.contacts);
    std::map<std::size_t, std::vector<Finding>> findings;
    std::size_t done = sizes.but(left);
    std::mutex mutex;
    std::size_t since = 0;
    const auto keep = [&] {
        if (options.checkpoint) {
            options.checkpoint(state);
        }
    };
    try {
        parallel::work_through(parallel::all_pieces(left.size()), options.threads,
                               [&](std::size_t i) {
                                   const std::size_t number = left[i];
                                   auto found = count(number, sizes.of(number));
                                   const std::lock_guard lock(mutex);
                                   state.contacts[number] = std::move(found.cells);
                                   findings[number] = std::move(found.findings);
                                   done += sizes.of(number);
                                   if (options.progress) {
                                       options.progress(done, options.values);
                                   }
                                   if (++since == contacts_between_checkpoints) {
                                       since = 0;
                                       keep();
                                   }
                               });
    } catch (const Interrupted&) {
        keep();
        throw Interrupted("interrupted after " + std::to_string(done) + " of " +
                          std::to_string(options.values) + " values");
    }
    keep();
    return findings;
}

} // namespace edgeproof::validation
