// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/checks/kinds.hpp"

#include <algorithm>
#include <array>

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
        {"value", {says, of, optional("scale", Type::formula)}, check_value},
        {"identity", {says, of, given}, check_identity},
        {"expansion",
         {says, of, required("variable", Type::text), required("through", Type::number), as_if,
          given},
         check_expansion},
        {"condition",
         {required("says", Type::condition),
          optional("holds", Type::choice, {"everywhere", "somewhere", "nowhere", "near-edge"}),
          optional("nearest", Type::number), optional("along", Type::text)},
         check_condition},
        {"series",
         {optional("terms", Type::formulas), required("orders", Type::list)},
         check_series},
        {"figure", {of}, check_figure, false},
        {"relations",
         {required("says", Type::choice, {"independent", "function"}), of,
          required("from", Type::formulas), optional("degree", Type::integer), given},
         check_relations},
    };
}

struct GoneKind {
    std::string_view name;
    std::string_view instead;
};
constexpr std::string_view next_value =
    "write kind = \"condition\" with along = \"NAME\" and says = \"next(f) > f\"; for a limit l, "
    "says = \"abs(next(f) - l) < abs(f - l)/2\"";
constexpr std::string_view loads = "write the values under each load as given(f, sig0 = 0) and "
                                   "given(f, Q = 0), in a claim of kind value or condition";
constexpr std::string_view remainder = "write kind = \"expansion\", or kind = \"condition\"";
constexpr std::array gone_kinds{
    GoneKind{"relation", "write kind = \"condition\""},
    GoneKind{"extent", "write kind = \"figure\" and of = \"exit(TERMS, TOLERANCE)/BASE\" or "
                       "\"measure(TERMS, TOLERANCE)/BASE\""},
    GoneKind{"monotone", next_value},
    GoneKind{"limit", next_value},
    GoneKind{"optimum", "write kind = \"condition\" and \"best(TERMS, TOLERANCE, m, FROM, TO)\""},
    GoneKind{"size-extent", "write kind = \"figure\" and sizes = [\"1\", \"2\", ...]"},
    GoneKind{"size-condition", "write kind = \"condition\" and sizes = [\"1\", \"2\", ...]"},
    GoneKind{"vanishing", loads},
    GoneKind{"superposition", loads},
    GoneKind{"independence", "write kind = \"value\" and the formula in u/L"},
    GoneKind{"dependence", "write kind = \"relations\""},
    GoneKind{"uniformity", remainder},
    GoneKind{"split", remainder},
    GoneKind{"order", remainder},
};

} // namespace

const std::vector<CheckKind>& check_kinds() {
    static const std::vector<CheckKind> kinds = all_kinds();
    return kinds;
}

const CheckKind* find_check_kind(std::string_view name) {
    const auto it = std::ranges::find(check_kinds(), name, &CheckKind::name);
    return it == check_kinds().end() ? nullptr : &*it;
}

std::string_view instead_of_kind(std::string_view name) {
    const auto* const gone = std::ranges::find(gone_kinds, name, &GoneKind::name);
    return gone == gone_kinds.end() ? std::string_view() : gone->instead;
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
        optional("sizes", Type::list),
        optional("remark", Type::text),
        optional("decimals", Type::choice, {"rounded", "exact"}),
    };
    return keys;
}

} // namespace edgeproof::audit
