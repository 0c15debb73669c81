// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/ledger.hpp"

#include "edgeproof/audit/check.hpp"
#include "edgeproof/audit/toml_reader.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <fstream>
#include <set>
#include <sstream>

namespace edgeproof {
namespace {

using Keys = std::vector<std::string_view>;

class LedgerReader {
public:
    LedgerReader(std::string_view text, const std::string& file)
        : document_(parse_toml(text, file)), file_(file) {}

    Ledger read() {
        ledger_.file = file_;
        const TomlTable top = document_.top();
        top.allow({"ledger", "define", "family", "claim"});
        const TomlTable head = top.table("ledger");
        head.allow({"name", "source"});
        ledger_.name = head.text("name");
        ledger_.source = head.text_or("source", "");
        for (const TomlTable& family : top.tables("family")) {
            read_family(family);
        }
        for (Family& family : ledger_.families) {
            try_drawing(family);
        }
        if (top.has("define")) {
            read_definitions(top.table("define"));
        }
        std::set<std::string> ids;
        for (const TomlTable& claim : top.tables("claim")) {
            read_claim(claim);
            if (!ids.insert(ledger_.claims.back().id).second) {
                claim.reject("id", "the id " + ledger_.claims.back().id + " stands twice",
                             "give each claim an id of its own");
            }
        }
        return std::move(ledger_);
    }

private:
    // --- families

    Expr family_formula(const TomlTable& table, std::size_t line, const std::string& text,
                        const Symbols& symbols) const {
        try {
            return parse(text, symbols);
        } catch (const InputError& error) {
            throw error.at(file_, line != 0 ? line : table.line());
        }
    }

    void read_family(const TomlTable& table) {
        table.allow(
            {"name", "profile", "parameters", "knots", "slopes", "u", "count", "points", "union"});
        Family family;
        family.line = table.line();
        family.name = table.text("name");
        for (const Family& other : ledger_.families) {
            if (other.name == family.name) {
                table.reject("name", "the family " + family.name + " stands twice",
                             "give each family a name of its own");
            }
        }
        if (table.has("union")) {
            table.allow({"name", "union", "count"});
            family.union_of = table.texts("union");
            family.count = table.has("count") ? table.count("count", 1, 1000000) : 0;
            for (const std::string& member : family.union_of) {
                if (std::none_of(ledger_.families.begin(), ledger_.families.end(),
                                 [&](const Family& f) { return f.name == member; })) {
                    table.reject("union", "there is no family '" + member + "' above",
                                 "name families that stand above the union");
                }
            }
            ledger_.families.push_back(std::move(family));
            return;
        }
        family.profile = table.text("profile");
        const TomlTable parameters = table.table("parameters");
        Symbols names;
        for (const std::string& name : parameters.keys()) {
            try {
                names.add(name);
            } catch (const InputError& error) {
                throw error.at(file_, parameters.line(name));
            }
        }
        std::size_t longest = 1;
        for (const std::string& name : parameters.keys()) {
            std::vector<Expr> values;
            for (const std::string& text : parameters.texts(name)) {
                values.push_back(family_formula(parameters, parameters.line(name), text, names));
            }
            if (values.empty()) {
                parameters.reject(name, "the parameter " + name + " has no value",
                                  "give at least one");
            }
            longest = std::max(longest, values.size());
            family.parameters.emplace_back(name, std::move(values));
        }
        for (const std::string_view needed : {"a", "Es"}) {
            if (!names.has(needed)) {
                table.reject("parameters",
                             "the family " + family.name + " has no " + std::string(needed),
                             "add " + std::string(needed) +
                                 " = [\"...\"] to its parameters (a: right edge, Es: E*)");
            }
        }
        for (const char* list : {"knots", "slopes"}) {
            if (!table.has(list)) {
                continue;
            }
            Symbols with_x = names;
            if (std::string_view(list) == "slopes") {
                with_x.add("x");
            }
            for (const std::string& text : table.texts(list)) {
                (std::string_view(list) == "knots" ? family.knots : family.slopes)
                    .push_back(family_formula(table, table.line(list), text, with_x));
            }
        }
        if (table.has("u")) {
            for (const std::string& text : table.texts("u")) {
                const Exact u(family_formula(table, table.line("u"), text, {}));
                if (u.sign() <= 0 || Exact(Expr::number(1) - u.expr()).sign() <= 0) {
                    table.reject("u", "the fraction u = " + text + " is not between 0 and 1",
                                 "give fractions of the contact's length, such as 1e-3");
                }
                family.u.push_back(u);
            }
        }
        family.count = table.has("count") ? table.count("count", 1, 1000000)
                                          : std::max<std::size_t>(longest, 8);
        family.points = table.has("points") ? table.count("points", 1, 10000) : 1;
        ledger_.families.push_back(std::move(family));
    }

    /// Every scene must be one that the mechanics admits.
    void try_drawing(const Family& family) const {
        try {
            for (const SceneSpec& scene : draw_scenes(family, ledger_.families)) {
                static_cast<void>(scene.make_profile());
                for (const char* positive : {"a", "Es"}) {
                    if (scene.parameter(positive).sign() <= 0) {
                        throw InputError(std::string(positive) + " = " +
                                             scene.parameter(positive).text() + " is not positive",
                                         "give " + std::string(positive) + " > 0");
                    }
                }
            }
        } catch (const InputError& error) {
            throw error.at(file_, family.line);
        }
    }

    // --- names

    /// Parameter names of a family; for a union those that all its members have.
    [[nodiscard]] std::set<std::string> parameters_of(const Family& family) const {
        std::set<std::string> names;
        if (family.union_of.empty()) {
            for (const auto& [name, values] : family.parameters) {
                names.insert(name);
            }
            return names;
        }
        for (std::size_t i = 0; i < family.union_of.size(); ++i) {
            const std::set<std::string> of = parameters_of(ledger_.family(family.union_of[i]));
            if (i == 0) {
                names = of;
            }
            std::erase_if(names, [&](const std::string& n) { return !of.contains(n); });
        }
        return names;
    }

    [[nodiscard]] static Symbols setting_names() {
        Symbols symbols;
        for (const std::string& name : setting_symbols()) {
            symbols.add(name);
        }
        for (const auto& [name, arity] : setting_functions()) {
            symbols.add_function(name, arity);
        }
        return symbols;
    }

    /// "F(s)" is a function of one argument, "gam" a name.
    static std::pair<std::string, std::optional<std::string>> signature(const std::string& key) {
        const std::size_t open = key.find('(');
        if (open == std::string::npos || key.back() != ')') {
            return {key, std::nullopt};
        }
        return {key.substr(0, open), key.substr(open + 1, key.size() - open - 2)};
    }

    static void add_name(Symbols& symbols, const std::string& key) {
        const auto [name, argument] = signature(key);
        if (argument) {
            symbols.add_function(name, 1);
        } else if (!symbols.has(name)) {
            symbols.add(name);
        }
    }

    Vocabulary::Definition definition(const std::string& key, const std::string& text,
                                      Symbols symbols, std::size_t line) const {
        const auto [name, argument] = signature(key);
        try {
            if (argument && !symbols.has(*argument)) {
                symbols.add(*argument);
            }
            return {name, argument, parse_formula(text, {symbols, {}})};
        } catch (const InputError& error) {
            throw error.at(file_, line);
        }
    }

    void read_definitions(const TomlTable& table) {
        // The bodies may use each other, and the parameters of any family.
        Symbols symbols = setting_names();
        for (const Family& family : ledger_.families) {
            for (const std::string& name : parameters_of(family)) {
                add_name(symbols, name);
            }
        }
        for (const std::string& key : table.keys()) {
            try {
                add_name(symbols, key);
            } catch (const InputError& error) {
                throw error.at(file_, table.line(key));
            }
        }
        for (const std::string& key : table.keys()) {
            ledger_.definitions.push_back(
                definition(key, table.text(key), symbols, table.line(key)));
        }
    }

    // --- claims

    void read_claim(const TomlTable& table) {
        Claim claim;
        claim.file = file_;
        claim.line = table.line();
        claim.id = table.text("id");
        claim.kind = table.text("kind");
        const CheckKind* kind = find_check_kind(claim.kind);
        if (kind == nullptr) {
            std::string known;
            for (const CheckKind& k : check_kinds()) {
                known += (known.empty() ? "" : ", ") + std::string(k.name);
            }
            table.reject("kind", "unknown kind '" + claim.kind + "'", "write one of " + known);
        }
        Keys own{"id", "kind", "lines", "printed", "undefined", "reading"};
        Keys shared;
        for (const auto& keys : {common_keys(), kind->keys}) {
            for (const KeySpec& key : keys) {
                shared.push_back(key.name);
            }
        }
        own.insert(own.end(), shared.begin(), shared.end());
        table.allow(own);
        claim.printed = table.text_or("printed", "");
        if (table.has("lines")) {
            const std::vector<std::string> lines = table.texts("lines");
            if (lines.size() != 2) {
                table.reject("lines", "lines of claim " + claim.id + " are not two numbers",
                             "write lines = [FIRST, LAST]");
            }
            claim.lines = {table.count_in("lines", lines[0]), table.count_in("lines", lines[1])};
        }
        if (table.has("undefined")) {
            claim.undefined = table.texts("undefined");
        }
        for (const std::string_view key : shared) {
            if (table.has(key)) {
                claim.fields.emplace(std::string(key), table.field(key));
            }
        }
        for (const TomlTable& part : table.tables_or_none("reading")) {
            Keys allowed{"text"};
            allowed.insert(allowed.end(), shared.begin(), shared.end());
            part.allow(allowed);
            Claim::Reading reading;
            reading.text = part.text("text");
            reading.line = part.line();
            for (const std::string_view key : shared) {
                if (part.has(key)) {
                    reading.fields.emplace(std::string(key), part.field(key));
                }
            }
            claim.readings.push_back(std::move(reading));
        }
        claim.vocabulary = vocabulary_of(claim);
        // With readings, the claim itself need not be complete.
        if (claim.readings.empty()) {
            check_fields(claim, *kind, true);
        } else {
            check_fields(claim, *kind, false);
            for (const Claim::Reading& reading : claim.readings) {
                check_fields(under_reading(ledger_, claim, reading), *kind, true);
            }
        }
        ledger_.claims.push_back(std::move(claim));
    }

public:
    /// All names that the formulas of a claim may use.
    static Vocabulary vocabulary_of(const Ledger& ledger, const Claim& claim) {
        LedgerReader reader(ledger);
        return reader.vocabulary_of(claim);
    }

private:
    explicit LedgerReader(const Ledger& ledger) : file_(ledger.file) {
        ledger_.file = ledger.file;
        ledger_.families = ledger.families;
        ledger_.definitions = ledger.definitions;
    }

    Vocabulary vocabulary_of(const Claim& claim) const {
        Vocabulary v;
        v.symbols = setting_names();
        v.definitions = ledger_.definitions;
        if (claim.has("over")) {
            const std::string& over = claim.text("over");
            const auto it = std::find_if(ledger_.families.begin(), ledger_.families.end(),
                                         [&](const Family& f) { return f.name == over; });
            if (it == ledger_.families.end()) {
                claim.reject("over", "there is no family '" + over + "'",
                             "name a family of this ledger");
            }
            for (const std::string& name : parameters_of(*it)) {
                add_name(v.symbols, name);
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
                add("vary", name);
            }
        }
        for (const std::string& name : claim.undefined) {
            add("undefined", name);
        }
        for (const auto& d : v.definitions) {
            add("", d.argument ? d.name + "(" + *d.argument + ")" : d.name);
        }
        if (claim.has("with")) {
            for (const auto& [key, values] : claim.table("with")) {
                add("with", key);
            }
            std::vector<Vocabulary::Definition> own;
            for (const auto& [key, values] : claim.table("with")) {
                if (values.size() != 1) {
                    claim.reject("with", key + " has " + std::to_string(values.size()) + " bodies",
                                 "write with = { " + key + " = \"...\" }");
                }
                own.push_back(definition(key, values.front(), v.symbols, claim.find("with")->line));
            }
            // A claim's own definition comes before the ledger's of the same name.
            own.insert(own.end(), v.definitions.begin(), v.definitions.end());
            v.definitions = std::move(own);
        }
        return v;
    }

    void check_fields(const Claim& claim, const CheckKind& kind, bool complete) const {
        for (const auto& keys : {common_keys(), kind.keys}) {
            for (const KeySpec& key : keys) {
                if (!claim.has(key.name)) {
                    if (key.required && complete) {
                        claim.reject(key.name,
                                     "claim " + claim.id + " of kind " + claim.kind + " has no " +
                                         std::string(key.name),
                                     "add " + std::string(key.name) + " = \"...\"");
                    }
                    continue;
                }
                check_field(claim, key);
            }
        }
    }

    void check_field(const Claim& claim, const KeySpec& key) const {
        using Type = KeySpec::Type;
        switch (key.type) {
        case Type::text:
            static_cast<void>(claim.text(key.name));
            break;
        case Type::formula:
            static_cast<void>(claim.formula(key.name));
            break;
        case Type::condition:
            static_cast<void>(claim.condition(key.name));
            break;
        case Type::integer:
            static_cast<void>(claim.integer(key.name));
            break;
        case Type::number:
            try {
                static_cast<void>(Exact::parse(claim.text(key.name)));
            } catch (const FormulaError& error) {
                claim.reject(key.name, error.problem(), error.instead());
            }
            break;
        case Type::list:
            static_cast<void>(claim.list(key.name));
            break;
        case Type::formulas:
            for (const std::string& text : claim.list(key.name)) {
                try {
                    static_cast<void>(parse_formula(text, claim.vocabulary));
                } catch (const FormulaError& error) {
                    claim.reject(key.name, error.problem(), error.instead());
                }
            }
            break;
        case Type::table:
            static_cast<void>(claim.table(key.name));
            break;
        case Type::choice: {
            const std::string& text = claim.text(key.name);
            if (std::find(key.choices.begin(), key.choices.end(), text) == key.choices.end()) {
                std::string known;
                for (const std::string_view choice : key.choices) {
                    known += (known.empty() ? "" : ", ") + std::string(choice);
                }
                claim.reject(key.name, std::string(key.name) + " = \"" + text + "\" is not known",
                             "write one of " + known);
            }
            break;
        }
        }
    }

    TomlDocument document_;
    std::string file_;
    Ledger ledger_;
};

} // namespace

const Family& Ledger::family(std::string_view wanted) const {
    for (const Family& f : families) {
        if (f.name == wanted) {
            return f;
        }
    }
    throw Error("the ledger has no family '" + std::string(wanted) + "'");
}

Ledger parse_ledger(std::string_view text, const std::string& file) {
    return LedgerReader(text, file).read();
}

Ledger read_ledger(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    if (!in || !std::filesystem::is_regular_file(file)) {
        throw InputError("the ledger cannot be read", "name a readable file").at(file.string(), 0);
    }
    std::ostringstream text;
    text << in.rdbuf();
    return parse_ledger(text.str(), file.string());
}

Claim under_reading(const Ledger& ledger, const Claim& claim, const Claim::Reading& reading) {
    Claim taken = claim;
    taken.readings.clear();
    taken.reading = reading.text;
    for (const auto& [key, field] : reading.fields) {
        taken.fields.insert_or_assign(key, field);
    }
    taken.vocabulary = LedgerReader::vocabulary_of(ledger, taken);
    return taken;
}

} // namespace edgeproof
