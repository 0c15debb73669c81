// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/validation/counts/count.hpp"

#include "edgeproof/validation/counts/contacts_counted.hpp"
#include "edgeproof/validation/counts/count_contact.hpp"

#include <utility>

namespace edgeproof::validation {

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
    auto findings = count_contacts_left<CountFinding>(
        options, state, sizes, [&options](std::size_t number, std::size_t values) {
            return count_contact(options, number, values);
        });
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
