// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cli/scene_command.hpp"

#include <string>
#include <vector>

namespace edgeproof::cli {
namespace {

struct RelationsOptions : OutputOptions {
    std::vector<std::string> quantities;
    std::vector<std::string> given;
    std::vector<std::string> free;
    std::string degree = "4";
    bool symmetric = false;
};

/// Splits "P2=m*P1/a" into a name and a formula.
std::pair<std::string, std::string> given_name(const std::string& text) {
    const std::size_t equals = text.find('=');
    require(equals != std::string::npos && equals != 0 && equals + 1 != text.size(),
            "--given " + text + " gives no name a formula", "write --given P2=m*P1/a");
    return {text.substr(0, equals), text.substr(equals + 1)};
}

int relations(const RelationsOptions& o) {
    audit::RelationQuestion question;
    question.quantities = o.quantities;
    question.degree =
        static_cast<long>(whole_number("--degree", o.degree, 1, audit::most_relation_degree));
    question.symmetric = o.symmetric;
    for (const std::string& text : o.given) {
        question.given.push_back(given_name(text));
    }
    question.free = o.free;
    const audit::AskedRelations asked = asked_relations(question);
    emit(report::relations_table(question, asked), o);
    return asked.found.complete ? 0 : 1;
}

} // namespace

void add_relations(CLI::App& app, int& code) {
    auto [sub, o] = add_command<RelationsOptions>(app, code, "relations", relations);
    option(sub, "quantities", o.quantities);
    option(sub, "--degree", o.degree);
    option(sub, "--symmetric", o.symmetric);
    option(sub, "--given", o.given);
    option(sub, "--free", o.free);
    add_table_options(sub, o);
}

} // namespace edgeproof::cli
