// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/report/tables/relations_table.hpp"

namespace edgeproof::report {

Table relations_table(const audit::RelationQuestion& question, const audit::AskedRelations& asked) {
    Table table;
    table.title = "polynomial relations that hold along every profile";
    std::string names;
    for (const std::string& text : question.quantities) {
        names += (names.empty() ? "" : ", ") + text;
    }
    std::string given;
    for (const auto& [name, formula] : question.given) {
        given += (given.empty() ? "" : ", ") + name + "=" + formula;
    }
    table.facts = {{"quantities", names},
                   {"degree", std::to_string(question.degree)},
                   {"contact", question.symmetric ? "symmetric" : "any"}};
    if (!given.empty()) {
        table.facts.push_back({"given", given});
    }
    table.facts.push_back({"monomials", std::to_string(asked.found.monomials)});
    table.facts.push_back({"complete", asked.found.complete ? "yes" : "no"});
    table.notes = {
        "each relation is proved by symbols: it holds identically in a, b and the derivatives of P "
        "and b that are not given"};
    table.notes.emplace_back(
        !asked.found.complete ? "a relation was found at samples and not proved: there may be more"
        : asked.found.relations.empty()
            ? "there is no relation of this degree or less: proved by the rank of their matrix at "
              "exact samples"
            : "every relation of this degree or less is a sum of multiples of these: proved by the "
              "rank of their matrix at exact samples");
    table.columns = {{"degree", Column::Kind::count}, {"relation", Column::Kind::text}};
    for (const audit::PolynomialRelation& r : asked.found.relations) {
        table.rows.push_back({std::to_string(r.degree()), relation_text(r, asked.quantities)});
    }
    return table;
}

} // namespace edgeproof::report
