// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/conformance/causes/convention.hpp"
#include "edgeproof/conformance/causes/convention_rule.hpp"
#include "edgeproof/conformance/causes/readings.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace edgeproof::conformance {
namespace {

using namespace convention_rule;

/// The references of the failing rows at the other edge, as far as they exist.
std::map<std::size_t, Ball> mirrored_references(const Answers& answers,
                                                const std::vector<std::size_t>& failing,
                                                ReferenceOptions options) {
    Questions mirrored;
    mirrored.file = answers.questions.file;
    mirrored.contacts = answers.questions.contacts;
    std::vector<std::size_t> of;
    for (const std::size_t i : failing) {
        Question q = answers.questions.list[i];
        if (q.at_edge() && !mirrored.contacts[q.contact].scene.symmetric()) {
            q.edge = opposite(q.edge);
            mirrored.list.push_back(std::move(q));
            of.push_back(i);
        }
    }
    options.digits = {most_digits, Rounding::nearest, false};
    std::map<std::size_t, Ball> balls;
    const auto values = references_where_any(mirrored, options);
    for (std::size_t k = 0; k < of.size(); ++k) {
        if (values[k]) { // otherwise it is a corner, seen from the other edge
            balls.emplace(of[k], values[k]->value.value);
        }
    }
    return balls;
}

/// Failing rows with a common property.
struct Group {
    std::string name;   ///< "p", "p, left edge", "c_1"
    std::string family; ///< "p", "c_k"
    std::vector<FailingRow> rows;
};

/// Assigns each failing row to its quantity (c_k and s_k together, and separately), at both edges
/// and at its own edge.
class Groups {
public:
    void add(const Question& q, const FailingRow& row) {
        const std::string name = symbol_of(q);
        const std::string family = family_of(q);
        add(family, family, row);
        if (q.at_edge()) {
            add(family + ", " + scene::edge_name(q.edge) + " edge", family, row);
        }
        if (family != name) {
            add(name, family, row);
        }
    }
    /// Sorts the largest group first; among groups of the same rows, the most specific name first.
    [[nodiscard]] std::vector<Group> sorted() && {
        const auto says = [](const std::string& name) {
            return name.size() + (name.ends_with("_k") ? 0 : 1);
        };
        std::stable_sort(groups_.begin(), groups_.end(), [&](const Group& x, const Group& y) {
            return x.rows.size() != y.rows.size() ? x.rows.size() > y.rows.size()
                                                  : says(x.name) > says(y.name);
        });
        return std::move(groups_);
    }

private:
    void add(const std::string& name, const std::string& family, const FailingRow& row) {
        const auto known = std::find_if(groups_.begin(), groups_.end(),
                                        [&](const Group& g) { return g.name == name; });
        (known == groups_.end() ? groups_.emplace_back(Group{name, family, {}}) : *known)
            .rows.push_back(row);
    }
    std::vector<Group> groups_;
};

/// Returns the rows with wrong values, not only with too few digits.
std::vector<std::size_t> rows_that_fail(const Answers& answers, const Agreements& agreements) {
    std::vector<std::size_t> failing;
    for (std::size_t i = 0; i < agreements.cases.size(); ++i) {
        const CaseAgreement& held = agreements.cases[i];
        if (answers.given[i].state == Answer::State::number && held.no_reference.empty() &&
            !held.pass && held.digits < same_digits &&
            !contains_zero(agreements.references[i].value.value)) {
            failing.push_back(i);
        }
    }
    return failing;
}

/// Merges equal conventions of several quantities.
std::vector<Convention> said_once(const std::vector<Convention>& found) {
    std::vector<Convention> merged;
    for (const Convention& c : found) {
        const auto same = std::find_if(merged.begin(), merged.end(), [&](const Convention& m) {
            return m.relation == c.relation && m.hint == c.hint;
        });
        if (same == merged.end()) {
            merged.push_back(c);
            continue;
        }
        same->of += "; " + c.of;
        const auto keep_common = [](std::vector<std::string>& kept,
                                    const std::vector<std::string>& others) {
            std::erase_if(kept, [&](const std::string& other) {
                return std::ranges::find(others, other) == others.end();
            });
        };
        keep_common(same->also, c.also);
        keep_common(same->equally_likely, c.equally_likely);
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
    const std::vector<std::size_t> failing = rows_that_fail(answers, agreements);
    std::vector<Convention> found = infer_precision_loss(answers, agreements);
    if (failing.size() < least_rows) {
        return said_once(found);
    }
    const auto mirrored = mirrored_references(answers, failing, options);
    Groups gathered;
    for (const std::size_t i : failing) {
        const Real value = Ball(answers.given[i].value, 256).midpoint();
        FailingRow row{i, value / agreements.references[i].value.value.midpoint(), {}};
        const auto other = mirrored.find(i);
        if (other != mirrored.end() && !contains_zero(other->second)) {
            row.mirrored = value / other->second.midpoint();
        }
        gathered.add(answers.questions.list[i], row);
    }
    const std::vector<Group> groups = std::move(gathered).sorted();
    std::set<std::size_t> explained;
    std::vector<std::pair<std::string, Convention>> by_factor; // with the family
    const auto look = [&](bool named) {
        for (const Group& group : groups) {
            const bool known =
                std::all_of(group.rows.begin(), group.rows.end(), [&](const FailingRow& row) {
                    return explained.contains(row.question);
                });
            if (const auto c = known ? std::nullopt : infer_factor(group.name, group.rows, named)) {
                by_factor.emplace_back(group.family, *c);
                for (const FailingRow& row : group.rows) {
                    explained.insert(row.question);
                }
            }
        }
    };
    look(true);
    std::vector<Convention> read_otherwise;
    for (Convention& reading : infer_readings(answers, agreements, failing, options)) {
        bool has_factor = false;
        for (auto& [family, factor] : by_factor) {
            if (family == reading.of) {
                has_factor = true;
                if (reading.held >= factor.held - as_good) {
                    factor.also.push_back(reading.relation);
                    factor.also.insert(factor.also.end(), reading.also.begin(), reading.also.end());
                    factor.equally_likely.push_back(reading.name);
                    factor.equally_likely.insert(factor.equally_likely.end(),
                                                 reading.equally_likely.begin(),
                                                 reading.equally_likely.end());
                }
            }
        }
        const auto rows = std::ranges::find(groups, reading.of, &Group::name);
        const auto factor = has_factor || rows == groups.end()
                                ? std::nullopt
                                : infer_factor(rows->name, rows->rows, false);
        if (factor && factor->held > reading.held + as_good) {
            continue; // a constant explains the answers better
        }
        if (factor && factor->held > reading.held + barely_better) {
            reading.also.push_back(factor->relation);
            reading.equally_likely.push_back(factor->name);
        }
        if (!has_factor) {
            for (const std::size_t i : failing) {
                if (family_of(answers.questions.list[i]) == reading.of) {
                    explained.insert(i);
                }
            }
            read_otherwise.push_back(std::move(reading));
        }
    }
    const std::size_t with_names = by_factor.size();
    look(false);
    for (std::size_t i = 0; i < by_factor.size(); ++i) {
        if (i == with_names) {
            found.insert(found.end(), read_otherwise.begin(), read_otherwise.end());
        }
        found.push_back(by_factor[i].second);
    }
    if (with_names == by_factor.size()) {
        found.insert(found.end(), read_otherwise.begin(), read_otherwise.end());
    }
    return said_once(found);
}

std::vector<std::string> unexplained(const Answers& answers, const Agreements& agreements,
                                     const std::vector<Convention>& conventions) {
    std::string explained;
    for (const Convention& c : conventions) {
        explained += "; " + c.of;
    }
    std::map<std::string, std::pair<std::size_t, bool>> families; // rows, explained
    for (const std::size_t i : rows_that_fail(answers, agreements)) {
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
        const CaseAgreement& held = agreements.cases[i];
        if (held.pass) {
            continue;
        }
        if (++seen_ > most) {
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
        agreements_.cases.push_back(held);
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
