// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/checks/kinds.hpp"

#include <algorithm>

namespace edgeproof::audit {
namespace {

using Type = KeySpec::Type;
using Choices = std::vector<std::string_view>;

KeySpec required(std::string_view name, Type type, Choices choices = {}) {
    return {name, type, true, std::move(choices)};
}
KeySpec optional(std::string_view name, Type type, Choices choices = {}) {
    return {name, type, false, std::move(choices)};
}

/// Nothing to check; with `of` the printed form is compared with the program's definition.
Outcome check_definition(const Claim&, const AuditContext&) {
    Outcome outcome;
    outcome.verdict = Judgement::definition();
    return outcome;
}

std::vector<CheckKind> all_kinds() {
    const KeySpec says = required("says", Type::formula);
    const KeySpec of = required("of", Type::formula);
    const KeySpec given = optional("given", Type::formula_table);
    const KeySpec as_if = optional("as_if", Type::formula_table);
    const KeySpec variable = required("variable", Type::text);
    const KeySpec small = required("small", Type::text);
    const KeySpec along = required("along", Type::text);
    const KeySpec through = required("through", Type::number);
    const KeySpec tolerance = required("tolerance", Type::number);
    const KeySpec terms = required("terms", Type::integer);
    const KeySpec loads = required("loads", Type::list);
    const KeySpec sizes = required("sizes", Type::list);
    return {
        {"definition", {optional("says", Type::text)}, check_definition},
        {"value", {says, of, optional("scale", Type::formula)}, check_value},
        {"identity", {says, of, given}, check_identity},
        {"expansion", {says, of, variable, through, as_if, given}, check_expansion},
        {"size-extent",
         {required("figure", Type::number), required("unit", Type::number), tolerance, terms,
          optional("over_terms", Type::integer), required("base", Type::choice, {"side", "whole"}),
          sizes, optional("together", Type::list)},
         check_size_extent,
         false},
        {"size-condition", {required("says", Type::condition), sizes}, check_size_condition},
        {"vanishing",
         {says, of, required("ratio", Type::formula), loads, optional("tolerances", Type::list),
          optional("elsewhere", Type::formulas)},
         check_vanishing},
        {"superposition",
         {required("says", Type::choice, {"add", "subtract"}), of,
          optional("when_zero", Type::formula), loads},
         check_superposition},
        {"independence", {of, required("at", Type::list)}, check_independence},
        {"dependence",
         {required("says", Type::choice, {"independent", "function"}), of,
          required("from", Type::formulas), optional("degree", Type::integer), given},
         check_dependence},
        {"uniformity",
         {required("says", Type::choice, {"breaks down", "uniform"}), of,
          required("approximation", Type::formula), optional("term", Type::formula), small,
          required("order", Type::integer), variable, required("towards", Type::number)},
         check_uniformity},
        {"split", {of, variable, small, through, as_if, given}, check_split},
        {"relation",
         {required("says", Type::condition),
          optional("holds", Type::choice, {"everywhere", "somewhere", "nowhere", "near-edge"}),
          optional("nearest", Type::number)},
         check_relation},
        {"order",
         {says, of, optional("factor", Type::choice, {"of-the-scene", "pure-number"}),
          optional("candidates", Type::formulas)},
         check_order},
        {"series",
         {optional("terms", Type::formulas), required("orders", Type::list)},
         check_series},
        {"figure", {of}, check_figure, false},
        {"extent",
         {terms, tolerance, required("base", Type::formula),
          required("reach", Type::choice, {"first-exit", "measure"}),
          optional("upto", Type::formula)},
         check_extent,
         false},
        {"monotone",
         {of, along, required("sense", Type::choice, {"increasing", "decreasing"})},
         check_monotone},
        {"limit", {of, along, required("limit", Type::formula, {"infinity"})}, check_limit},
        {"optimum",
         {along, required("at", Type::number), required("between", Type::list), terms,
          required("tolerances", Type::list), optional("sense", Type::choice, {"each", "limit"}),
          optional("upto", Type::number)},
         check_optimum},
    };
}

} // namespace

const std::vector<CheckKind>& check_kinds() {
    static const std::vector<CheckKind> kinds = all_kinds();
    return kinds;
}

const CheckKind* find_check_kind(std::string_view name) {
    const auto it = std::ranges::find(check_kinds(), name, &CheckKind::name);
    return it == check_kinds().end() ? nullptr : &*it;
}

const std::vector<KeySpec>& common_keys() {
    static const std::vector<KeySpec> keys{
        optional("over", Type::text),
        optional("edge", Type::choice, {"right", "left"}),
        optional("where", Type::condition),
        optional("quoted", Type::text),
        optional("with", Type::table),
        optional("vary", Type::table),
        optional("points", Type::integer),
        optional("remark", Type::text),
        optional("decimals", Type::choice, {"rounded", "exact"}),
    };
    return keys;
}

} // namespace edgeproof::audit
