// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/audit/ledger/ledger.hpp"

#include "edgeproof/audit/ledger/claim.hpp"
#include "edgeproof/audit/ledger/judgement.hpp"
#include "edgeproof/audit/ledger/ledger_parts.hpp"
#include "edgeproof/io/text_file.hpp"
#include "edgeproof/io/toml/toml_section.hpp"
#include "edgeproof/io/toml/toml_text.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/message.hpp"
#include "edgeproof/scene/input/scene_file.hpp"

#include <algorithm>
#include <set>

namespace edgeproof::audit {
namespace {

using Keys = std::vector<std::string_view>;

constexpr long most_lines = 1'000'000'000;

Field read_field(const io::TomlSection& section, std::string_view key) {
    Field field;
    field.line = section.line(key);
    if (section.is_list(key)) {
        field.value = section.written_list(key);
    } else if (section.is_table(key)) {
        const io::TomlSection table = section.section(key);
        Field::Table entries;
        for (const std::string& name : table.keys()) {
            entries.emplace_back(name, table.written_list(name));
        }
        field.value = std::move(entries);
    } else {
        field.value = section.written(key);
    }
    return field;
}

/// The names of kinds or of keys.
template <class Named> Keys names_of(const std::vector<Named>& all) {
    Keys names;
    std::ranges::transform(all, std::back_inserter(names), &Named::name);
    return names;
}

class LedgerReader {
public:
    LedgerReader(std::string_view text, const std::string& file, ClaimErrors errors)
        : top_(io::TomlSection::parse(text, file)), file_(file), errors_(errors) {}

    Ledger read() {
        ledger_.file = file_;
        expect_file_kind(top_, scene::FileKind::ledger);
        top_.allow({"ledger", "define", "family", "claim", "later", "print", "notation"});
        const io::TomlSection head = top_.section("ledger");
        head.allow({"name", "source", "doi", "arxiv", "version"});
        ledger_.name = head.written("name");
        ledger_.source = head.written_or("source", "");
        ledger_.print = read_printed_source(top_);
        for (const io::TomlSection& family : top_.sections("family")) {
            io::at_place(file_, family.line(), [&] {
                ledger_.families.push_back(read_family(family, file_, ledger_.families));
            });
        }
        for (const Family& family : ledger_.families) {
            try_drawing(family, file_, ledger_.families);
        }
        if (top_.has("define")) {
            ledger_.definitions = read_definitions(ledger_, top_.section("define"));
        }
        std::set<std::string> ids;
        for (const io::TomlSection& claim : top_.sections("claim")) {
            try {
                io::at_place(file_, claim.line(), [&] {
                    Claim read = read_claim(claim);
                    if (!ids.insert(read.id).second) {
                        claim.reject("id", "the id " + read.id + " is given twice",
                                     "give each claim a different id");
                    }
                    ledger_.claims.push_back(std::move(read));
                });
            } catch (const InputError& error) {
                if (errors_ == ClaimErrors::thrown) {
                    throw;
                }
                ledger_.errors.push_back({id_of(claim), error});
            }
        }
        for (const io::TomlSection& later : top_.sections_or_none("later")) {
            io::at_place(file_, later.line(), [&] { read_later(later); });
        }
        if (ledger_.errors.empty()) { // a claim that was not read may use any parameter
            refuse_unused_parameters(ledger_);
        }
        return std::move(ledger_);
    }

private:
    /// Returns the claim that a key names; nullptr if that claim could not be read.
    const Claim* named_claim(const io::TomlSection& table, std::string_view key) const {
        const std::string id = table.written(key);
        const auto it = std::ranges::find(ledger_.claims, id, &Claim::id);
        if (it == ledger_.claims.end() &&
            std::ranges::find(ledger_.errors, id, &ClaimError::id) == ledger_.errors.end()) {
            table.reject(key, "the ledger has no claim '" + id + "'", "write the id of a claim");
        }
        return it == ledger_.claims.end() ? nullptr : &*it;
    }

    void read_later(const io::TomlSection& table) {
        table.allow({"from", "claim", "words", "says", "with"});
        const Claim* from = named_claim(table, "from");
        const Claim* claim = named_claim(table, "claim");
        if (from == nullptr || claim == nullptr) {
            return;
        }
        Vocabulary vocabulary = claim->vocabulary;
        const auto define = [&](const std::string& name, const Expr& body) {
            vocabulary.symbols.add(name);
            vocabulary.definitions.insert(vocabulary.definitions.begin(), {name, {}, body});
        };
        const auto formula_at = [&](const io::TomlSection& where, const std::string& key,
                                    const std::string& text) {
            try {
                return parse_formula(text, vocabulary);
            } catch (const formula::FormulaError& error) {
                where.reject(key, error.problem(), error.instead());
            }
        };
        if (table.has("with")) {
            const io::TomlSection with = table.section("with");
            for (const std::string& name : with.keys()) {
                define(name, formula_at(with, name, with.written(name)));
            }
        }
        define("printed", from->written("says"));
        ledger_.later.push_back(
            {from->id, claim->id, table.text("words"),
             expand_definitions(formula_at(table, "says", table.text("says")), vocabulary)});
    }

    static std::string id_of(const io::TomlSection& table) {
        try {
            return table.written_or("id", "");
        } catch (const InputError&) {
            return "";
        }
    }

    [[nodiscard]] Claim read_claim(const io::TomlSection& table) const {
        Claim claim;
        claim.file = file_;
        claim.line = table.line();
        claim.id = table.written("id");
        if (claim.id.empty() || printable(claim.id) != claim.id) {
            table.reject("id", "the id of a claim is empty or holds control characters",
                         "write a name in one line");
        }
        claim.kind = table.written("kind");
        const std::vector<CheckKind>& kinds = check_kinds();
        const auto kind = std::ranges::find(kinds, claim.kind, &CheckKind::name);
        if (kind == kinds.end()) {
            table.reject("kind", "unknown kind '" + claim.kind + "'",
                         one_of(claim.kind, names_of(kinds)));
        }
        claim.check = &*kind;
        const Keys shared = names_of(kind->keys);
        Keys own{"id", "kind", "lines", "printed", "undefined", "reading"};
        own.insert(own.end(), shared.begin(), shared.end());
        table.allow(own);
        claim.printed = table.written_or("printed", "");
        if (const auto fault = tex_fault(claim.printed, ledger_.print.macros)) {
            table.reject("printed",
                         "printed of claim " + claim.id + " cannot be used: " + fault->problem,
                         fault->instead);
        }
        if (table.has("lines")) {
            const std::vector<std::size_t> lines = table.counts("lines", 0, most_lines);
            if (lines.size() != 2) {
                table.reject("lines", "lines of claim " + claim.id + " are not two numbers",
                             "write lines = [FIRST, LAST]");
            }
            claim.lines = {lines[0], lines[1]};
        }
        if (table.has("undefined")) {
            claim.undefined = table.written_list("undefined");
        }
        read_shared(table, shared, claim);
        claim.vocabulary = vocabulary_of(ledger_, claim);
        const std::vector<io::TomlSection> readings = table.sections_or_none("reading");
        for (const io::TomlSection& part : readings) {
            Keys allowed{"text"};
            allowed.insert(allowed.end(), shared.begin(), shared.end());
            part.allow(allowed);
            Claim reading = claim;
            reading.readings.clear();
            reading.reading = part.written("text");
            read_shared(part, shared, reading);
            claim.readings.push_back(std::move(reading));
        }
        // A claim with readings need not be complete itself.
        read_fields(claim, readings.empty());
        for (Claim& reading : claim.readings) {
            reading.vocabulary = vocabulary_of(ledger_, reading);
            read_fields(reading, true);
        }
        return claim;
    }

    static void read_shared(const io::TomlSection& table, const Keys& keys, Claim& claim) {
        for (const std::string_view key : keys) {
            if (table.has(key)) {
                claim.fields.insert_or_assign(std::string(key), read_field(table, key));
            }
        }
    }

    static void read_fields(Claim& claim, bool complete) {
        for (const KeySpec& key : claim.check->keys) {
            if (claim.has(key.name)) {
                claim.read(key);
            } else if (key.required && complete && !claim.has(key.unless)) {
                claim.reject(key.name,
                             "claim " + claim.id + " of kind " + claim.kind + " has no " +
                                 std::string(key.name),
                             "add " + std::string(key.name) + " = \"...\"");
            }
        }
    }

    io::TomlSection top_;
    std::string file_;
    ClaimErrors errors_;
    Ledger ledger_;
};

} // namespace

const Family& Ledger::family(std::string_view wanted) const {
    const auto it = std::ranges::find(families, wanted, &Family::name);
    if (it == families.end()) {
        throw Error("the ledger has no family '" + std::string(wanted) + "'");
    }
    return *it;
}

std::vector<const Family*> Ledger::members(const Family& of) const {
    if (of.union_of.empty()) {
        return {&of};
    }
    std::vector<const Family*> all;
    for (const std::string& member : of.union_of) {
        std::ranges::copy(members(family(member)), std::back_inserter(all));
    }
    return all;
}

Ledger parse_ledger(std::string_view text, const std::string& file, ClaimErrors errors) {
    return LedgerReader(text, file, errors).read();
}

Ledger read_ledger(const std::filesystem::path& file, ClaimErrors errors) {
    return parse_ledger(io::read_text(file, "ledger (TOML)", io::most_toml_bytes),
                        io::input_name(file), errors);
}

} // namespace edgeproof::audit
