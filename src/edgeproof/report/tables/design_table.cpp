// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/report/tables/design_table.hpp"
#include "edgeproof/precision/rounding/text.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace edgeproof::report {
namespace {

constexpr unsigned digits_of_an_estimate = 10;

std::string reach_note(const scene::DesignScene& design) {
    return std::string(design.objective == scene::DesignObjective::measure
                           ? "the length of all places at which the terms are within the tolerance"
                           : "the first distance from the edge at which the terms are off by the "
                             "tolerance") +
           (design.unit == contact::ReachUnit::fraction ? ", as a fraction of a + b" : "");
}

const char* optimum_text(contact::BestReach::Kind kind, bool proved) {
    using How = contact::BestReach::Kind;
    switch (kind) {
    case How::touching:
        return "an extremum of the error touches the tolerance";
    case How::smooth:
        return "a maximum of the reach";
    case How::two_edges:
        return "both edges reach equally far";
    case How::end_of_range:
        return "an end of the range";
    case How::everywhere:
        return "within the tolerance in the whole part considered";
    case How::box:
        break;
    }
    return proved ? "in the box of all values that are not excluded"
                  : "the best of the values tried";
}

} // namespace

Table design_table(const scene::DesignScene& design, const scene::DesignResult& result,
                   const contact::DesignOptions& search) {
    const contact::BestReach& best = result.best;
    const bool proved = result.proved();
    scene::Digits digits;
    digits.count = search.digits;
    const auto text = [&](const Ball& x) {
        if (!proved) {
            return scene::PrintedValue{
                to_decimal(x.midpoint(), std::min(search.digits, digits_of_an_estimate)),
                "",
                true,
                false,
                {}};
        }
        return printed(scene::BoundedValue{x, true, "", {}}, digits);
    };
    Table table;
    table.title = design.title;
    table.facts = {{"scene", design.file},
                   {"digits", std::to_string(search.digits)},
                   {"tolerance", design.tolerance.text()},
                   {"terms", std::to_string(design.terms)},
                   {"best", optimum_text(best.kind, proved)},
                   {"proof", proved ? "yes" : "no (estimate): " + result.missing}};
    if (proved) {
        table.facts.push_back({"boxes", std::to_string(best.boxes)});
        table.facts.push_back(
            {"reach shown at", to_decimal(*best.shown_at, 20, Rounding::nearest)});
        table.facts.push_back(
            {"not excluded", best.not_excluded ? contact::range_text(*best.not_excluded) : ""});
    }
    if (best.touches_at) {
        table.facts.push_back({"touches at", text(*best.touches_at).text});
    }
    if (result.printed_reach) {
        table.facts.push_back({"printed", exact_text(*design.printed)});
        table.facts.push_back({"reach at printed", text(*result.printed_reach).text});
        table.facts.push_back({"falls short by", text(*result.falls_short).text});
    }
    table.notes = {
        "reach: " + reach_note(design),
        proved ? "gap: no other value in the range reaches farther by more than this: proved by "
                 "branch and bound"
               : "value and reach are estimates: no bound and no gap is proved"};
    if (proved) {
        table.notes.emplace_back("not excluded: values that reach as far as the reach shown are in "
                                 "this range; everywhere else the reach is proved to be less");
    }
    if (!best.attained) {
        table.remarks.emplace_back(
            "the reach jumps at the value: it is approached from one side and "
            "not attained");
    }
    table.columns = {{"parameter", Column::Kind::text},
                     {"value"},
                     {"value_bound"},
                     {"reach"},
                     {"reach_bound"},
                     {"gap"}};
    table.columns[0].phrase = "{} =";
    table.columns[1].phrase = "{}";
    table.columns[2].role = Column::Role::bound;
    table.columns[4].role = Column::Role::bound;
    const scene::PrintedValue reach = text(best.reach);
    const scene::PrintedValue value = text(best.value);
    table.rows.push_back({design.parameter, value.text, value.bound, reach.text, reach.bound,
                          proved ? exact_text(search.gap) : ""});
    return table;
}

Table relations_table(const audit::RelationQuestion& question, const audit::AskedRelations& asked) {
    Table table;
    table.title = "polynomial relations that hold along every profile";
    std::string given;
    for (const auto& [name, formula] : question.given) {
        given += (given.empty() ? "" : ", ") + name + "=" + formula;
    }
    table.facts = {{"quantities", fmt::format("{}", fmt::join(question.quantities, ", "))},
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
    table.remarks.emplace_back(
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
