// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/audit/checks/kinds.hpp"

#include "edgeproof/algebra/identity.hpp"

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
    const std::vector<KeySpec> common{
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
    const KeySpec says = required("says", Type::formula);
    const KeySpec of = required("of", Type::formula);
    const KeySpec given = optional("given", Type::formula_table);
    const KeySpec as_if = optional("as_if", Type::formula_table);
    std::vector<CheckKind> kinds{
        {"definition", {optional("says", Type::text)}, check_definition},
        {"compare",
         {{"says", Type::formula, true, {}, "quoted"},
          optional("quoted", Type::figures),
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
    for (CheckKind& kind : kinds) {
        kind.keys.insert(kind.keys.begin(), common.begin(), common.end());
    }
    return kinds;
}

bool is_symmetric(const Family* family) {
    return !family->profile.starts_with("tilted-") && family->profile != "piecewise";
}

/// Returns m if g' is a multiple of x^m on each side in all scenes of a plane family, and known so.
std::optional<Rational> power_of_slope(const Family& family) {
    if (family.axisymmetric()) {
        return {}; // P is a multiple of a^(m + 2)
    }
    if (family.profile == "wedge" || family.profile == "tilted-wedge") {
        return 0;
    }
    if (family.profile == "piecewise-symmetric" && family.slopes.size() == 1) {
        const Expr x = Expr::symbol("x");
        const Expr& slope = family.slopes.front();
        const Expr linear = substitute(slope, "x", Expr::number(1)) * x;
        return algebra::proved_zero(slope - linear) ? std::optional(Rational(1)) : std::nullopt;
    }
    for (const auto& [name, values] : family.parameters) {
        if (family.profile == "power-law" && name == "m" && values.size() == 1 &&
            free_symbols(values.front()).empty()) {
            const Exact m(values.front());
            return m.is_rational() ? std::optional(m.rational()) : std::nullopt;
        }
    }
    return family.profile == "hertz" ? std::optional(Rational(1)) : std::nullopt;
}

} // namespace

const std::vector<CheckKind>& check_kinds() {
    static const std::vector<CheckKind> kinds = all_kinds();
    return kinds;
}

std::vector<std::pair<std::string, Expr>> named_formulas(const Claim& claim, std::string_view key) {
    std::vector<std::pair<std::string, Expr>> named;
    const Field* field = claim.find(key);
    for (std::size_t i = 0; field != nullptr && i < claim.formulas(key).size(); ++i) {
        const auto* list = std::get_if<Field::List>(&field->value);
        named.emplace_back(list != nullptr ? list->at(i) : claim.table(key)[i].first,
                           claim.formulas(key)[i]);
    }
    return named;
}

SymbolicCase symbolic_case(const Claim& claim, const AuditContext& context) {
    SymbolicCase under;
    const Ledger& ledger = context.ledger();
    under.symmetric =
        claim.has("over") &&
        std::ranges::all_of(ledger.members(ledger.family(claim.text("over"))), is_symmetric);
    for (const auto& [name, formula] : named_formulas(claim, "given")) {
        if (name != "P" && name != "b") {
            claim.reject("given", "given contains " + name + ", from which nothing is derived",
                         "write given = { P = \"...\", b = \"...\" }, formulas in a");
        }
        (name == "P" ? under.P : under.b) = formula;
    }
    for (const Sample& sample :
         claim.has("over") ? context.samples(claim) : std::vector<Sample>()) {
        for (const auto* values : {&sample.variables, &sample.scene.parameters}) {
            for (const auto& [name, value] : *values) {
                if (value.sign() <= 0) {
                    under.either_sign.insert(name);
                }
            }
        }
    }
    return under;
}

SymbolicCase case_of_powers(const Claim& claim, const AuditContext& context) {
    SymbolicCase under = symbolic_case(claim, context);
    const Ledger& ledger = context.ledger();
    std::optional<Rational> power;
    for (const Family* family : ledger.members(ledger.family(claim.text("over")))) {
        const auto m = power_of_slope(*family);
        if (!m || (power && power != m)) {
            return under;
        }
        power = m;
    }
    const Expr a = Expr::symbol("a");
    if (power && !under.P) {
        under.P = Expr::symbol("factor of P") * pow(a, Expr::number(*power + 1));
    }
    if (power && !under.b && !under.symmetric) { // of a tilted wedge
        under.b = Expr::symbol("factor of b") * a;
    }
    return under;
}

} // namespace edgeproof::audit
