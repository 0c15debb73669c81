// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/validation/count.hpp"

#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/validation/count_contact.hpp"
#include "edgeproof/validation/state_text.hpp"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <mutex>
#include <set>
#include <utility>

namespace edgeproof::validation {
namespace {

constexpr std::size_t contacts_a_checkpoint = 20;

} // namespace

void CountCell::add(const CountCell& o) {
    values += o.values;
    excluded += o.excluded;
    wrong += o.wrong;
    wide += o.wide;
    undecided += o.undecided;
}

CountResult count_values(const CountOptions& options, CountState& state) {
    state.seed = options.seed;
    state.values = options.values;
    state.digits = options.digits;
    const ContactSizes sizes{options.values, values_a_contact};
    const std::vector<std::size_t> left = contacts_left(sizes.contacts(), state.contacts);
    std::map<std::size_t, std::vector<CountFinding>> findings;
    std::mutex mutex;
    std::size_t since = 0;
    std::size_t done = sizes.but(left);
    const auto one = [&](std::size_t i) {
        const std::size_t number = left[i];
        CountedContact found = count_contact(options, number, sizes.of(number));
        const std::lock_guard lock(mutex);
        state.contacts[number] = std::move(found.cells);
        findings[number] = std::move(found.findings);
        done += sizes.of(number);
        if (options.progress) {
            options.progress(done, options.values);
        }
        if (options.checkpoint && ++since == contacts_a_checkpoint) {
            since = 0;
            options.checkpoint(state);
        }
    };
    tbb::task_arena arena(options.threads == 0 ? tbb::task_arena::automatic
                                               : static_cast<int>(options.threads));
    try {
        arena.execute([&] {
            tbb::parallel_for(
                tbb::blocked_range<std::size_t>(0, left.size(), 1),
                [&](const auto& range) {
                    for (std::size_t i = range.begin(); i < range.end(); ++i) {
                        one(i);
                    }
                },
                tbb::simple_partitioner());
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
    CountResult result;
    for (const auto& [number, cells] : state.contacts) {
        for (const auto& [cell, found] : cells) {
            result.cells.at(cell / sampled_regimes.size())
                .at(cell % sampled_regimes.size())
                .add(found);
            result.total.add(found);
        }
    }
    for (auto& [number, list] : findings) {
        for (CountFinding& f : list) {
            result.findings.push_back(std::move(f));
        }
    }
    return result;
}

} // namespace edgeproof::validation
