// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/conformance/causes/convention.hpp"
#include "edgeproof/conformance/causes/readings.hpp"

#include <algorithm>
#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace edgeproof::conformance {
namespace {

using namespace convention_rule;

/// Failing rows with a common property.
struct Group {
    std::string name;   ///< "p", "p, left edge", "c_1"
    std::string family; ///< "p", "c_k"
    std::vector<FailingRow> rows;
};

/// Groups the rows by quantity (c_k and s_k together, and separately), at both edges and at each
/// edge. The largest group comes first; among groups of the same rows, the most specific name.
std::vector<Group> groups_of(const Questions& questions, const std::vector<FailingRow>& rows) {
    std::vector<Group> groups;
    for (const FailingRow& row : rows) {
        const Question& q = questions.list[row.question];
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

/// Returns the rows with wrong values, not only with too few digits, that none of `known` explains.
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

/// Merges equal conventions of several quantities.
std::vector<Convention> merged(const std::vector<Convention>& found) {
    std::vector<Convention> merged;
    for (const Convention& c : found) {
        const auto same = std::ranges::find_if(merged, [&](const Convention& m) {
            return m.relation == c.relation && m.hint == c.hint;
        });
        if (same == merged.end()) {
            merged.push_back(c);
            continue;
        }
        same->of += "; " + c.of;
        for (auto list : {&Convention::also, &Convention::equally_likely}) {
            std::erase_if((*same).*list, [&](const std::string& other) {
                return std::ranges::find(c.*list, other) == (c.*list).end();
            });
        }
        same->digits = std::min(same->digits, c.digits);
        same->held = std::min(same->held, c.held);
        same->rows += c.rows;
        same->failing += c.failing;
    }
    return merged;
}

} // namespace

std::vector<Convention> infer_conventions(const Answers& answers, const Agreements& agreements,
                                          const ReferenceOptions& options) {
    const PrecisionScope scope(most_digits + 20);
    std::vector<Convention> found = infer_precision_loss(answers, agreements);
    std::ranges::move(infer_cancellation(answers, agreements), std::back_inserter(found));
    const std::vector<std::size_t> failing = rows_that_fail(answers, agreements, found);
    if (failing.size() < least_rows) {
        return merged(found);
    }
    Reading at_other_edge;
    at_other_edge.place = [](Question& q, const scene::Scene& scene) {
        q.edge = opposite(q.edge);
        return q.at_edge() && !scene.symmetric();
    };
    ReferenceOptions all_digits = options;
    all_digits.digits = {most_digits, Rounding::nearest, false};
    const auto mirrored =
        values_read_otherwise(answers, agreements, at_other_edge, failing, all_digits);
    std::vector<FailingRow> rows;
    for (std::size_t k = 0; k < failing.size(); ++k) {
        const std::size_t i = failing[k];
        const Real value = Ball(answers.given[i].value, 256).midpoint();
        rows.push_back({i, value / agreements.references[i].value.value.midpoint(), {}});
        if (mirrored[k]) {
            rows.back().mirrored = value / *mirrored[k];
        }
    }
    const std::vector<Group> groups = groups_of(answers.questions, rows);
    std::set<std::size_t> explained;
    std::vector<std::pair<std::string, Convention>> by_family;
    const auto look_for_factors = [&](bool named) {
        for (const Group& group : groups) {
            const bool known = std::ranges::all_of(group.rows, [&](const FailingRow& row) {
                return explained.contains(row.question);
            });
            if (const auto c = known ? std::nullopt : infer_factor(group.name, group.rows, named)) {
                by_family.emplace_back(group.family, *c);
                for (const FailingRow& row : group.rows) {
                    explained.insert(row.question);
                }
            }
        }
    };
    look_for_factors(true);
    std::vector<std::pair<std::string, Convention>> readings;
    for (Convention& reading : infer_readings(answers, agreements, failing, options)) {
        bool has_factor = false;
        for (auto& [family, factor] : by_family) {
            if (family != reading.of) {
                continue;
            }
            has_factor = true;
            if (reading.held >= factor.held - as_good) {
                factor.also.push_back(reading.relation);
                factor.equally_likely.push_back(reading.name);
                std::ranges::copy(reading.also, std::back_inserter(factor.also));
                std::ranges::copy(reading.equally_likely,
                                  std::back_inserter(factor.equally_likely));
            }
        }
        const auto group = std::ranges::find(groups, reading.of, &Group::name);
        if (has_factor || group == groups.end()) {
            continue;
        }
        const auto factor = infer_factor(group->name, group->rows, false);
        if (factor && factor->held > reading.held + as_good) {
            continue; // a constant explains the answers better
        }
        if (factor && factor->held > reading.held + barely_better) {
            reading.also.push_back(factor->relation);
            reading.equally_likely.push_back(factor->name);
        }
        for (const FailingRow& row : group->rows) {
            explained.insert(row.question);
        }
        readings.emplace_back(reading.of, std::move(reading));
    }
    std::ranges::move(readings, std::back_inserter(by_family));
    look_for_factors(false);
    for (auto& [family, convention] : by_family) {
        found.push_back(std::move(convention));
    }
    return merged(found);
}

std::vector<std::string> unexplained(const Answers& answers, const Agreements& agreements,
                                     const std::vector<Convention>& conventions) {
    std::string explained;
    for (const Convention& c : conventions) {
        explained += "; " + c.of;
    }
    std::map<std::string, std::pair<std::size_t, bool>> families; // rows, explained
    for (const std::size_t i : rows_that_fail(answers, agreements, conventions)) {
        const Question& q = answers.questions.list[i];
        auto& [rows, known] = families[family_of(q)];
        ++rows;
        for (const std::string& name : {family_of(q), symbol_of(q)}) {
            known = known || (explained + ";").find("; " + name + ";") != std::string::npos ||
                    explained.find("; " + name + ",") != std::string::npos;
        }
    }
    std::vector<std::string> names;
    for (const auto& [family, rows] : families) {
        if (rows.first >= least_rows && !rows.second) {
            names.push_back(family);
        }
    }
    return names;
}

void FailingRows::add(const Answers& answers, const Agreements& agreements) {
    std::map<std::size_t, std::size_t> contacts; // from the block to those kept
    answers_.questions.file = answers.questions.file;
    agreements_.digits = agreements.digits;
    for (std::size_t i = 0; i < agreements.cases.size(); ++i) {
        if (agreements.cases[i].pass || ++seen_ > most) {
            continue;
        }
        Question q = answers.questions.list[i];
        const auto [found, is_new] =
            contacts.emplace(q.contact, answers_.questions.contacts.size());
        if (is_new) {
            answers_.questions.contacts.push_back(answers.questions.contacts[q.contact]);
        }
        q.contact = found->second;
        answers_.questions.list.push_back(std::move(q));
        answers_.given.push_back(answers.given[i]);
        agreements_.cases.push_back(agreements.cases[i]);
        agreements_.references.push_back(agreements.references[i]);
    }
}

std::vector<Convention> FailingRows::conventions(const ReferenceOptions& options) const {
    return infer_conventions(answers_, agreements_, options);
}

std::vector<std::string>
FailingRows::unexplained_by(const std::vector<Convention>& conventions) const {
    return unexplained(answers_, agreements_, conventions);
}

} // namespace edgeproof::conformance
