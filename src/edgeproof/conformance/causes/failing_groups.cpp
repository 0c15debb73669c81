// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/conformance/causes/failing_groups.hpp"

#include "edgeproof/conformance/causes/readings.hpp"

#include <algorithm>
#include <functional>
#include <set>
#include <utility>

namespace edgeproof::conformance {
namespace {

constexpr double same_digits = 6; // as same_value

} // namespace

std::vector<Group> groups_of(const Questions& questions, const std::vector<std::size_t>& rows) {
    std::vector<Group> groups;
    for (const std::size_t row : rows) {
        const Question& q = questions.list[row];
        const std::string family = family_of(q);
        const auto add = [&](const std::string& name) {
            auto known = std::ranges::find(groups, name, &Group::name);
            if (known == groups.end()) {
                known = groups.insert(known, {name, family, {}});
            }
            known->rows.push_back(row);
        };
        add(family);
        if (q.at_edge()) {
            add(family + ", " + scene::edge_name(q.edge) + " edge");
        }
        if (symbol_of(q) != family) {
            add(symbol_of(q));
        }
    }
    std::ranges::stable_sort(groups, std::greater(), [](const Group& g) {
        return std::pair(g.rows.size(), g.name.size() + (g.name.ends_with("_k") ? 0 : 1));
    });
    return groups;
}

std::vector<std::size_t> rows_that_fail(const Answers& answers, const Agreements& agreements,
                                        const std::vector<Convention>& known) {
    std::set<std::size_t> explained;
    for (const Convention& c : known) {
        explained.insert(c.which.begin(), c.which.end());
    }
    std::vector<std::size_t> failing;
    for (std::size_t i = 0; i < agreements.cases.size(); ++i) {
        const CaseAgreement& held = agreements.cases[i];
        if (answers.given[i].state == Answer::State::number && held.no_reference.empty() &&
            !held.pass && held.digits < same_digits && !explained.contains(i) &&
            !contains_zero(agreements.references[i].value.value)) {
            failing.push_back(i);
        }
    }
    return failing;
}

} // namespace edgeproof::conformance
