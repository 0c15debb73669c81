// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/cli/scene_command.hpp"

#include <string>
#include <vector>

namespace edgeproof::cli {
namespace {

/// Splits "P2=m*P1/a" into a name and a formula.
std::pair<std::string, std::string> given_name(const std::string& text) {
    const std::size_t equals = text.find('=');
    require(equals != std::string::npos && equals != 0 && equals + 1 != text.size(),
            "--given " + text + " gives no name a formula", "write --given P2=m*P1/a");
    return {text.substr(0, equals), text.substr(equals + 1)};
}

} // namespace

int relations(Options& o) {
    audit::RelationQuestion question;
    question.quantities = o.list("quantities");
    question.degree =
        static_cast<long>(whole_number("--degree", o["--degree"], 1, audit::most_relation_degree));
    question.symmetric = o.has("--symmetric");
    for (const std::string& text : o.list("--given")) {
        question.given.push_back(given_name(text));
    }
    question.free = o.list("--free");
    const audit::AskedRelations asked = asked_relations(question);
    emit(report::relations_table(question, asked), o);
    return asked.found.complete ? 0 : 1;
}

} // namespace edgeproof::cli
