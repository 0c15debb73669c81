// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/conformance/causes/convention.hpp"

#include "edgeproof/conformance/causes/cause_search.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

namespace edgeproof::conformance {
namespace {

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
        same->remains = std::max(same->remains, c.remains);
        same->digits = std::min(same->digits, c.digits);
        same->held = std::min(same->held, c.held);
        same->rows += c.rows;
        same->failing += c.failing;
    }
    return merged;
}

} // namespace

std::vector<Convention> infer_conventions(const Answers& answers, const Agreements& agreements,
                                          const ReferenceOptions& options, KnownReadings& known) {
    const PrecisionScope scope(most_cause_digits + 20);
    std::vector<Convention> found = infer_precision_loss(answers, agreements);
    std::ranges::move(infer_cancellation(answers, agreements), std::back_inserter(found));
    const std::vector<std::size_t> failing = rows_that_fail(answers, agreements, found);
    if (failing.size() >= least_rows) {
        std::ranges::move(CauseSearch(answers, agreements, failing, options, known).causes(),
                          std::back_inserter(found));
    }
    return merged(found);
}

std::vector<Convention> infer_conventions(const Answers& answers, const Agreements& agreements,
                                          const ReferenceOptions& options) {
    KnownReadings known;
    return infer_conventions(answers, agreements, options, known);
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
