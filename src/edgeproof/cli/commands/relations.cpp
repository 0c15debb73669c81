// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/relations/relations.hpp"
#include "edgeproof/audit/ledger/claim.hpp"
#include "edgeproof/audit/ledger/scene_names.hpp"
#include "edgeproof/cli/cli.hpp"
#include "edgeproof/cli/scene_command.hpp"
#include "edgeproof/precision/error.hpp"

#include <memory>
#include <string>
#include <vector>

namespace edgeproof::cli {
namespace {

constexpr std::size_t most_degree = 12;

struct RelationsOptions : SceneOptions {
    std::vector<std::string> quantities;
    std::vector<std::string> given;
    std::vector<std::string> free;
    std::string degree = "4";
    bool symmetric = false;
};

/// "P2=m*P1/a" as a name and a formula.
std::pair<std::string, std::string> given_name(const std::string& text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == text.size()) {
        throw InputError("--given " + text + " gives no name a formula", "write --given P2=m*P1/a");
    }
    return {text.substr(0, equals), text.substr(equals + 1)};
}

formula::Expr formula_of(const std::string& option, const std::string& text,
                         const audit::Vocabulary& vocabulary) {
    try {
        return audit::parse_formula(text, vocabulary);
    } catch (const InputError& error) {
        throw InputError(option + text + ": " + error.problem(), error.instead());
    }
}

int relations(const RelationsOptions& o) {
    audit::Vocabulary vocabulary;
    for (const std::string& name : audit::scene_symbols()) {
        if (name != "u" && name != "x" && name != "M") {
            vocabulary.symbols.add(name);
        }
    }
    vocabulary.symbols.add("Q");
    vocabulary.symbols.add("sig0");
    for (const std::string& name : o.free) {
        vocabulary.symbols.add(name);
    }
    audit::SymbolicCase under;
    under.symmetric = o.symmetric;
    for (const std::string& text : o.given) {
        const auto [name, formula] = given_name(text);
        if (!vocabulary.symbols.has(name)) {
            throw InputError("--given " + text + ": there is no '" + name + "'",
                             "give P1, P2, ..., b, b1, ... as formulas in what is left free");
        }
        under.names.emplace(name, formula_of("--given ", formula, vocabulary));
    }
    std::vector<audit::RelatedQuantity> quantities;
    for (const std::string& text : o.quantities) {
        quantities.push_back({text, formula_of("", text, vocabulary)});
    }
    const auto degree = static_cast<unsigned>(whole_number("--degree", o.degree, 1, most_degree));
    const audit::FoundRelations found = audit::find_relations(quantities, degree, under);
    report::Table table;
    table.title = "polynomial relations that hold along every profile";
    std::string names;
    for (const std::string& text : o.quantities) {
        names += (names.empty() ? "" : ", ") + text;
    }
    table.facts = {{"quantities", names},
                   {"degree", std::to_string(degree)},
                   {"contact", o.symmetric ? "symmetric" : "any"}};
    for (const std::string& text : o.given) {
        table.facts.push_back({"given", text});
    }
    table.facts.push_back({"monomials", std::to_string(found.monomials)});
    table.facts.push_back({"complete", found.complete ? "yes" : "no"});
    table.notes = {
        "each relation is proved by symbols: it holds identically in a, b and the derivatives of P "
        "and b that are not given"};
    table.notes.emplace_back(
        !found.complete ? "a relation was found at samples and not proved: there may be more"
        : found.relations.empty()
            ? "there is no relation of this degree or less: proved by the rank of their matrix at "
              "exact samples"
            : "every relation of this degree or less is a sum of multiples of these: proved by the "
              "rank of their matrix at exact samples");
    table.columns = {{"degree", report::Column::Kind::count},
                     {"relation", report::Column::Kind::text}};
    for (const audit::PolynomialRelation& r : found.relations) {
        table.rows.push_back({std::to_string(r.degree()), relation_text(r, quantities)});
    }
    emit(table, o);
    return found.complete ? 0 : 1;
}

} // namespace

void add_relations(CLI::App& app, int& code) {
    CLI::App* sub = app.add_subcommand(
        "relations", "polynomial relations between multipliers that hold along every profile");
    auto o = std::make_shared<RelationsOptions>();
    sub->add_option("quantities", o->quantities,
                    "left.c1, right.c0, right.s0, b1, L, ...: what they are between; powers of the "
                    "first are eliminated first")
        ->required();
    sub->add_option("--degree", o->degree, "total degree up to which all are found (default: 4)");
    sub->add_flag("--symmetric", o->symmetric, "b = a");
    sub->add_option("--given", o->given, "NAME=FORMULA, such as P2=m*P1/a: what is not free");
    sub->add_option("--free", o->free, "a further free name, such as m");
    sub->add_option("--format", o->format, "csv, json, md or tex")->capture_default_str();
    sub->add_option("--out", o->out,
                    "write to this file, whole or not at all (-: standard output)");
    sub->callback([o, &code] { code = relations(*o); });
}

} // namespace edgeproof::cli
