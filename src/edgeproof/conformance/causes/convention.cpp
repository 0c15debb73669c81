// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/conformance/causes/convention.hpp"

#include "edgeproof/conformance/causes/readings.hpp"

#include <algorithm>
#include <iterator>
#include <set>
#include <sstream>
#include <utility>

namespace edgeproof::conformance {
namespace {

constexpr unsigned cause_search_digits = 60;
constexpr double same_digits = 6; ///< as diagnose::same_value

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
        if (has_value(answers, agreements, i) && !held.pass && held.digits < same_digits &&
            !explained.contains(i)) {
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
                                          const ReferenceOptions& options, KnownReadings* known) {
    const PrecisionScope scope(cause_search_digits);
    std::vector<Convention> found = infer_precision_loss(answers, agreements);
    std::ranges::move(infer_cancellation(answers, agreements), std::back_inserter(found));
    std::vector<std::size_t> failing = rows_that_fail(answers, agreements, found);
    failing.resize(std::min(failing.size(), most_failing));
    if (failing.size() >= diagnose::least_rows) {
        KnownReadings own;
        std::ranges::move(causes_of_wrong_rows(answers, agreements, failing, options,
                                               known == nullptr ? own : *known),
                          std::back_inserter(found));
    }
    return merged(found);
}

std::vector<std::string> unexplained(const Answers& answers, const Agreements& agreements,
                                     const std::vector<Convention>& conventions) {
    std::set<std::string> known; // "p; c_1, left edge": p and c_1
    for (const Convention& c : conventions) {
        std::istringstream all(c.of);
        for (std::string part; std::getline(all >> std::ws, part, ';');) {
            known.insert(part.substr(0, part.find(',')));
        }
    }
    std::map<std::string, std::pair<std::size_t, bool>> families; // rows, explained
    for (const std::size_t i : rows_that_fail(answers, agreements, conventions)) {
        const Question& q = answers.questions.list[i];
        auto& [rows, explained] = families[family_of(q)];
        ++rows;
        explained = explained || known.contains(family_of(q)) || known.contains(symbol_of(q));
    }
    std::vector<std::string> names;
    for (const auto& [family, rows] : families) {
        if (rows.first >= diagnose::least_rows && !rows.second) {
            names.push_back(family);
        }
    }
    return names;
}

} // namespace edgeproof::conformance
