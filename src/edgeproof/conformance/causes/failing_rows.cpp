// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/conformance/causes/failing_rows.hpp"

#include <map>
#include <utility>

namespace edgeproof::conformance {

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
