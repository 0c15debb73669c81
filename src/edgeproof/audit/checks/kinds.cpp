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
    return {
        {"definition", {optional("says", Type::text)}, check_definition},
        {"compare",
         {{"says", Type::formula, true, {}, "quoted"},
          optional("quoted", Type::text),
          of,
          optional("scale", Type::formula),
          given},
         check_compare},
        {"expansion",
         {says, of, required("variable", Type::text), required("through", Type::number), as_if,
          given},
         check_expansion},
        {"condition",
         {required("says", Type::condition),
          optional("holds", Type::choice, {"everywhere", "somewhere", "nowhere", "near-edge"}),
          optional("along", Type::text)},
         check_condition},
        {"relations",
         {required("says", Type::choice, {"independent", "function"}), of,
          required("from", Type::formulas), optional("degree", Type::integer), given},
         check_relations},
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
        optional("with", Type::table),
        optional("vary", Type::table),
        optional("points", Type::integer),
        optional("sizes", Type::list),
        optional("remark", Type::text),
        optional("decimals", Type::choice, {"rounded", "exact"}),
    };
    return keys;
}

} // namespace edgeproof::audit
