// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/ledger/ledger_names.hpp"

#include "edgeproof/audit/ledger/ledger.hpp"
#include "edgeproof/audit/ledger/scene_names.hpp"
#include "edgeproof/io/toml/toml_section.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <set>

namespace edgeproof::audit {
namespace {

/// Returns the parameter names of a family; for a union, those common to all members.
std::set<std::string> parameters_of(const Ledger& ledger, const Family& family) {
    std::set<std::string> names;
    if (family.union_of.empty()) {
        for (const auto& [name, values] : family.parameters) {
            names.insert(name);
        }
        return names;
    }
    for (std::size_t i = 0; i < family.union_of.size(); ++i) {
        const std::set<std::string> of = parameters_of(ledger, ledger.family(family.union_of[i]));
        if (i == 0) {
            names = of;
        }
        std::erase_if(names, [&](const std::string& n) { return !of.contains(n); });
    }
    return names;
}

formula::Symbols scene_names() {
    formula::Symbols symbols;
    for (const auto* names : {&scene_symbols(), &slip_symbols()}) {
        for (const std::string& name : *names) {
            symbols.add(name);
        }
    }
    for (const auto& [name, arity] : scene_functions()) {
        symbols.add_function(name, arity);
    }
    return symbols;
}

/// True if some scene of the family has friction, and if all scenes have it.
struct Friction {
    bool some = false;
    bool all = true;
};
Friction friction_of(const Ledger& ledger, const Family& family) {
    Friction friction;
    if (family.union_of.empty()) {
        friction.some = friction.all = family.has("friction");
    }
    for (const std::string& name : family.union_of) {
        const Friction of = friction_of(ledger, ledger.family(name));
        friction.some = friction.some || of.some;
        friction.all = friction.all && of.all;
    }
    return friction;
}

/// Returns the name as it is written in ledgers: "right.s0".
std::string dotted(std::string name) {
    if (name.starts_with("right_") || name.starts_with("left_")) {
        name[name.find('_')] = '.';
    }
    return name;
}

/// Refuses the names of full stick in a family with friction, and the names of slip in one without,
/// unless the ledger defines them itself.
void refuse_names(Vocabulary& v, const Friction& friction, const std::string& family) {
    if (friction.some) {
        for (const std::string& name : scene_symbols()) {
            if (is_full_stick_symbol(name)) {
                v.refused[name] = {dotted(name) + " is a coefficient of q under full stick, and " +
                                       "family " + family + " has friction",
                                   "use a family without friction, or write q(x), right.d, left.d, "
                                   "stick_a, stick_b, which are those of partial slip"};
            }
        }
    }
    if (!friction.all) {
        for (const std::string& name : slip_symbols()) {
            v.refused[name] = {
                dotted(name) + " is a quantity of partial slip, and family " + family +
                    " has no friction",
                "add friction = [\"...\"] and Q = [\"...\"] to the parameters of the "
                "family"};
        }
    }
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
    const auto [name, argument] = signature(key);
    try {
        if (argument && !symbols.has(*argument)) {
            symbols.add(*argument);
        }
        return {name, argument, parse_formula(text, {symbols, {}})};
    } catch (const InputError& error) {
        throw error.at(file, line);
    }
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
        try {
            add_name(symbols, key);
        } catch (const InputError& error) {
            throw error.at(ledger.file, table.line(key));
        }
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
        refuse_names(v, friction_of(ledger, *it), over);
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

} // namespace edgeproof::audit
