// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/audit/ledger/ledger.hpp"
#include "edgeproof/audit/ledger/ledger_parts.hpp"
#include "edgeproof/io/text_file.hpp"
#include "edgeproof/io/toml/toml_section.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <array>
#include <set>

namespace edgeproof::audit {
namespace {

/// Returns the parameter names of a family; for a union, those common to all members.
std::set<std::string> parameters_of(const Ledger& ledger, const Family& family) {
    const std::vector<const Family*> members = ledger.members(family);
    std::set<std::string> names;
    for (const auto& parameter : members.front()->parameters) {
        const std::string& name = parameter.first;
        if (std::ranges::all_of(members, [&](const Family* f) { return f->has(name); })) {
            names.insert(name);
        }
    }
    return names;
}

/// Of a body in plane strain, or of revolution, as scenes name them.
constexpr std::array<std::string_view, 10> stresses{"sxx",     "szz",    "sxz", "syy", "mises",
                                                    "tau_max", "tresca", "s1",  "s2",  "s3"};
/// The greatest ones and their places: of plane contacts, and on the axis of a body of revolution.
constexpr std::array<std::string_view, 13> greatest_stresses{
    "greatest_tau_max", "greatest_tau_max_x", "greatest_tau_max_z", "greatest_mises",
    "greatest_mises_x", "greatest_mises_z",   "greatest_sxx",       "greatest_sxx_x",
    "greatest_sxx_z",   "axis_tau_max",       "axis_tau_max_z",     "axis_mises",
    "axis_mises_z"};

/// Returns the name as it is written in ledgers: "right.s0".
std::string dotted(std::string name) {
    for (const char* const before : {"right_", "left_", "greatest_", "axis_"}) {
        if (name.starts_with(before)) {
            name[name.find('_')] = '.';
        }
    }
    return name;
}

bool is_one_of(std::string_view name, std::initializer_list<std::string_view> names) {
    return std::ranges::find(names, name) != names.end();
}

/// Returns why a name of scenes has no meaning in the contacts of a family; nothing if it has one.
/// For a body of revolution, P is the total force, delta the approach, and p(x) the pressure.
std::optional<Vocabulary::Refusal> refusal_of(const std::string& name, const Family& family,
                                              const std::vector<const Family*>& members) {
    using Refusal = Vocabulary::Refusal;
    const auto slips = [](const Family* f) { return f->has("friction"); };
    const bool all_slip = std::ranges::all_of(members, slips);
    const bool of_slip = is_slip_symbol(name);
    const bool of_all = of_slip || is_one_of(name, {"a", "L", "P", "u", "x", "p", "given", "next"});
    const bool of_bodies_of_revolution = is_one_of(name, {"Es", "gap", "p_max"}) ||
                                         is_stress(name) || name.starts_with("right_c") ||
                                         name.starts_with("left_c") || (all_slip && name == "q");
    const bool of_stick =
        order_behind(name, "right_s").has_value() || order_behind(name, "left_s").has_value();
    const bool of_punches = of_stick || is_one_of(name, {"b", "q"}) || family.has(name);
    const std::string missing =
        "'" + dotted(name) + "' is not available: family " + family.name + " is ";
    if (family.axisymmetric() && !of_all && !of_bodies_of_revolution) {
        return Refusal{missing + "axisymmetric",
                       "use a, Es, P (the total force), delta (the approach), u, x, p(x), gap(x), "
                       "right.c0, right.c1, ... or stresses such as szz(x, z); with friction also "
                       "q(x), right.d and stick_a"};
    }
    if (is_greatest(name) && family.profile != "sphere" &&
        name.starts_with(family.axisymmetric() ? "greatest" : "axis")) {
        return Refusal{dotted(name) + (family.axisymmetric()
                                           ? " is proved off the axis of a sphere only"
                                           : " is a value on the axis of a body of revolution"),
                       "write axis.tau_max, axis.tau_max.z (or mises), the greatest on the axis of "
                       "a body of revolution, and greatest.tau_max, ... in plane contacts"};
    }
    if (is_flat_punch(family.profile) && !of_all && !of_punches) {
        return Refusal{missing + "a flat punch",
                       "use a, b, L, P, u, x, p(x), or right.s0, right.s1, ..., the coefficients "
                       "of u^(-1/2), u^(1/2), ..."};
    }
    if (of_stick && std::ranges::any_of(members, slips)) {
        return Refusal{dotted(name) + " is a coefficient of q under full stick, and family " +
                           family.name + " has friction",
                       "use a family without friction, or write q(x), right.d, left.d, stick_a, "
                       "stick_b, which are those of partial slip"};
    }
    if ((of_slip || name == "slip") && !all_slip) {
        return Refusal{
            dotted(name) + " is a quantity of partial slip, and family " + family.name +
                " has no friction",
            "add friction = [\"...\"] and Q = [\"...\"] to the parameters of the family"};
    }
    return {};
}

/// Splits "F(s)" into a function name and its argument; "gam" has no argument.
std::pair<std::string, std::optional<std::string>> signature(const std::string& key) {
    const std::size_t open = key.find('(');
    if (open == std::string::npos || key.back() != ')') {
        return {key, std::nullopt};
    }
    return {key.substr(0, open), key.substr(open + 1, key.size() - open - 2)};
}

void add_name(formula::Symbols& symbols, const std::string& key) {
    const auto [name, argument] = signature(key);
    if (argument) {
        symbols.add_function(name, 1);
    } else if (!symbols.has(name)) {
        symbols.add(name);
    }
}

Vocabulary::Definition definition(const std::string& key, const std::string& text,
                                  formula::Symbols symbols, const std::string& file,
                                  std::size_t line) {
    const auto signed_by = signature(key); // clang 14: lambdas capture no structured bindings
    return io::at_place(file, line, [&]() -> Vocabulary::Definition {
        const auto& [name, argument] = signed_by;
        if (argument && !symbols.has(*argument)) {
            symbols.add(*argument);
        }
        return {name, argument, parse_formula(text, {symbols, {}})};
    });
}

/// Places the claim's own definitions before the ledger's definitions of the same names.
void put_own_first(Vocabulary& v, const Ledger& ledger, const Claim& claim) {
    std::vector<Vocabulary::Definition> own;
    for (const auto& [key, values] : claim.table("with")) {
        if (values.size() != 1) {
            claim.reject("with", key + " has " + std::to_string(values.size()) + " bodies",
                         "write with = { " + key + " = \"...\" }");
        }
        own.push_back(
            definition(key, values.front(), v.symbols, ledger.file, claim.find("with")->line));
    }
    own.insert(own.end(), v.definitions.begin(), v.definitions.end());
    v.definitions = std::move(own);
}

} // namespace

std::vector<Vocabulary::Definition> read_definitions(const Ledger& ledger,
                                                     const io::TomlSection& table) {
    formula::Symbols symbols = scene_names();
    for (const Family& family : ledger.families) {
        for (const std::string& name : parameters_of(ledger, family)) {
            add_name(symbols, name);
        }
    }
    for (const std::string& key : table.keys()) {
        io::at_place(ledger.file, table.line(key), [&] { add_name(symbols, key); });
    }
    std::vector<Vocabulary::Definition> all;
    for (const std::string& key : table.keys()) {
        all.push_back(definition(key, table.written(key), symbols, ledger.file, table.line(key)));
    }
    return all;
}

Vocabulary vocabulary_of(const Ledger& ledger, const Claim& claim) {
    Vocabulary v;
    v.symbols = scene_names();
    v.definitions = ledger.definitions;
    std::set<std::string> parameters;
    if (claim.has("over")) {
        const std::string& over = claim.text("over");
        const auto it = std::find_if(ledger.families.begin(), ledger.families.end(),
                                     [&](const Family& f) { return f.name == over; });
        if (it == ledger.families.end()) {
            claim.reject("over", "there is no family '" + over + "'",
                         "name a family of this ledger");
        }
        for (const std::string& name : parameters_of(ledger, *it)) {
            add_name(v.symbols, name);
            parameters.insert(name);
        }
        const bool punch = is_flat_punch(it->profile);
        if ((it->axisymmetric() || punch) &&
            !is_one_of(claim.kind, {"definition", "compare", "condition"})) {
            claim.reject("over",
                         "family " + over + " is " + (punch ? "a flat punch" : "axisymmetric") +
                             ", and claim " + claim.id + " is of kind " + claim.kind,
                         "write kind = \"compare\" or \"condition\", or use another family");
        }
        if (it->axisymmetric()) {
            add_name(v.symbols, "delta");
        }
        if (punch) { // the pressure is the traction of full stick under Q = P (SceneSpec::names())
            v.definitions.push_back({"p", "s", Expr::call("q", {Expr::symbol("s")})});
        }
        const std::vector<const Family*> members = ledger.members(*it);
        const auto refuse = [&](const std::string& name) {
            if (auto refusal = refusal_of(name, *it, members)) {
                v.refused.emplace(name, *std::move(refusal));
            }
        };
        std::ranges::for_each(scene_names().variables(), refuse);
        for (const auto& [name, arguments] : scene_names().functions()) {
            refuse(name);
        }
    }
    const auto add = [&](std::string_view key, const std::string& name) {
        try {
            add_name(v.symbols, name);
        } catch (const InputError& error) {
            claim.reject(key, error.problem(), error.instead());
        }
    };
    if (claim.has("vary")) {
        for (const auto& [name, values] : claim.table("vary")) {
            if (parameters.contains(name)) {
                claim.reject("vary",
                             name + " is a parameter of family " + claim.text("over") +
                                 ": values in `vary` have no effect on the contact",
                             "give its values in the parameters of the family");
            }
            add("vary", name);
            v.refused.erase(name);
        }
    }
    for (const std::string& name : claim.undefined) {
        add("undefined", name);
        v.refused.erase(name);
    }
    for (const auto& d : v.definitions) {
        add("", d.argument ? d.name + "(" + *d.argument + ")" : d.name);
    }
    if (claim.has("with")) {
        for (const auto& [key, values] : claim.table("with")) {
            add("with", key);
        }
        put_own_first(v, ledger, claim);
    }
    return v;
}

bool is_slip_symbol(std::string_view name) {
    return is_one_of(name, {"right_d", "left_d", "stick_a", "stick_b"});
}

bool is_greatest(std::string_view name) {
    return std::ranges::find(greatest_stresses, name) != greatest_stresses.end();
}

bool is_stress(std::string_view name) {
    return is_greatest(name) || std::ranges::find(stresses, name) != stresses.end();
}

const formula::Symbols& scene_names() {
    static const formula::Symbols names = [] {
        formula::Symbols all{"a", "b",       "Es",     "P",       "M",       "L",    "u",
                             "x", "right_d", "left_d", "stick_a", "stick_b", "p_max"};
        for (int k = 0; k <= 9; ++k) {
            for (const char* stem : {"right_c", "left_c", "right_s", "left_s", "P", "b"}) {
                if (k > 0 || std::string_view(stem).size() > 1) { // P and b themselves
                    all.add(stem + std::to_string(k));
                }
            }
        }
        for (const std::string_view greatest : greatest_stresses) {
            all.add(std::string(greatest));
        }
        for (const std::string_view stress : stresses) {
            all.add_function(stress, 2);
        }
        const std::pair<const char*, unsigned> functions[] = {
            {"p", 1},       {"g1", 1},   {"Pof", 1},         {"P1of", 1},
            {"bof", 1},     {"binv", 1}, {"right_local", 2}, {"left_local", 2},
            {"q", 1},       {"gap", 1},  {"slip", 1},        {"exit", 2},
            {"measure", 2}, {"best", 5}, {"given", 3},       {"next", 1}};
        for (const auto& [name, arity] : functions) {
            all.add_function(name, arity);
        }
        return all;
    }();
    return names;
}

} // namespace edgeproof::audit
