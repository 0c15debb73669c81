// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/audit/ledger/ledger_parts.hpp"

#include "edgeproof/audit/ledger/ledger.hpp"
#include "edgeproof/formula/parse.hpp"
#include "edgeproof/io/text_file.hpp"
#include "edgeproof/io/toml/toml_section.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <string_view>
#include <utility>

namespace edgeproof::audit {
namespace {

class FamilyReader {
public:
    FamilyReader(const io::TomlSection& table, const std::string& file)
        : table_(table), file_(file) {
        table_.allow({"name", "profile", "geometry", "parameters", "knots", "slopes", "u", "count",
                      "points", "union"});
        family_.line = table_.line();
        family_.name = table_.written("name");
    }

    Family read(const std::vector<Family>& above) {
        const auto is_above = [&](const std::string& name) {
            return std::ranges::any_of(above, [&](const Family& f) { return f.name == name; });
        };
        if (is_above(family_.name)) {
            table_.reject("name", "the family " + family_.name + " is given twice",
                          "give each family a different name");
        }
        if (!table_.has("union")) {
            read_own();
            return std::move(family_);
        }
        table_.allow({"name", "union", "count"});
        family_.union_of = table_.written_list("union");
        family_.count = table_.has("count") ? table_.count("count", 1, most_samples) : 0;
        for (const std::string& member : family_.union_of) {
            if (!is_above(member)) {
                table_.reject("union", "there is no family '" + member + "' above",
                              "name families that are defined above the union");
            }
            const auto of = std::ranges::find(above, member, &Family::name);
            if (of->axisymmetric() || is_flat_punch(of->profile)) {
                table_.reject("union",
                              "the family '" + member + "' is " +
                                  (of->axisymmetric() ? "axisymmetric" : "a flat punch"),
                              "name families of plane contacts with a slope only");
            }
        }
        return std::move(family_);
    }

private:
    static constexpr std::size_t most_samples = 100'000; ///< about 10 kB each, so 1 GB

    void read_own() {
        family_.profile = table_.written("profile");
        family_.geometry = table_.written_or("geometry", "");
        const std::size_t longest = read_parameters();
        formula::Symbols with_x = names_;
        with_x.add("x");
        family_.knots = formulas("knots", names_);
        family_.slopes = formulas("slopes", with_x);
        read_fractions();
        family_.count = table_.has("count") ? table_.count("count", 1, most_samples)
                                            : std::max<std::size_t>(longest, 8);
        family_.points = table_.has("points") ? table_.count("points", 1, most_samples) : 1;
        if (family_.points > most_samples / family_.count) {
            table_.reject(
                "points",
                std::to_string(family_.count) + " scenes of " + std::to_string(family_.points) +
                    " points each are samples for more than 1 GB of memory",
                "give count and points with a product of at most " + std::to_string(most_samples));
        }
    }

    /// Returns the length of the longest list.
    std::size_t read_parameters() {
        const io::TomlSection parameters = table_.section("parameters");
        for (const std::string& name : parameters.keys()) {
            io::at_place(file_, parameters.line(name), [&] { names_.add(name); });
            refuse_computed(parameters, name);
            family_.lines.emplace(name, parameters.line(name));
        }
        std::size_t longest = 1;
        for (const std::string& name : parameters.keys()) {
            std::vector<Expr> values;
            for (const std::string& text : parameters.written_list(name)) {
                values.push_back(formula(parameters.line(name), text, names_));
            }
            if (values.empty()) {
                parameters.reject(name, "the parameter " + name + " has no value",
                                  "give at least one");
            }
            longest = std::max(longest, values.size());
            family_.parameters.emplace_back(name, std::move(values));
        }
        return longest;
    }

    /// Refuses a parameter that would hide a value computed by the scene.
    void refuse_computed(const io::TomlSection& parameters, const std::string& name) const {
        const bool without_a = !parameters.has("a") || is_flat_punch(family_.profile);
        const bool given =
            name == "a" || name == "Es" || ((name == "P" || name == "delta") && without_a);
        const bool computed =
            scene_names().has(name) || (family_.axisymmetric() && name == "delta");
        if (computed && !given) {
            parameters.reject(name,
                              name + " is computed from the other parameters and the place: a "
                                     "parameter of this name has no effect on the contact",
                              "leave it out, or give it another name");
        }
    }

    void read_fractions() {
        if (!table_.has("u")) {
            return;
        }
        for (const std::string& text : table_.written_list("u")) {
            const Exact u(formula(table_.line("u"), text, {}));
            if (u.sign() <= 0 || Exact(Expr::number(1) - u.expr()).sign() <= 0) {
                table_.reject("u", "the fraction u = " + text + " is not between 0 and 1",
                              "give fractions of the contact's length, such as 1e-3");
            }
            family_.u.push_back(u);
        }
    }

    [[nodiscard]] std::vector<Expr> formulas(std::string_view key,
                                             const formula::Symbols& symbols) const {
        std::vector<Expr> all;
        if (table_.has(key)) {
            for (const std::string& text : table_.written_list(key)) {
                all.push_back(formula(table_.line(key), text, symbols));
            }
        }
        return all;
    }

    [[nodiscard]] Expr formula(std::size_t line, const std::string& text,
                               const formula::Symbols& symbols) const {
        return io::at_place(file_, line != 0 ? line : table_.line(),
                            [&] { return parse(text, symbols); });
    }

    const io::TomlSection& table_;
    const std::string& file_;
    formula::Symbols names_;
    Family family_;
};

} // namespace

Family read_family(const io::TomlSection& table, const std::string& file,
                   const std::vector<Family>& above) {
    return FamilyReader(table, file).read(above);
}

void try_drawing(const Family& family, const std::string& file, const std::vector<Family>& all) {
    const std::vector<SceneSpec> scenes = io::at_place(file, family.line, [&] {
        std::vector<SceneSpec> drawn = draw_scenes(family, all);
        for (const SceneSpec& scene : drawn) {
            static_cast<void>(scene.as_scene());
            if (scene.flat_punch() && scene.parameter("P").sign() <= 0) {
                throw InputError("P = " + scene.parameter("P").text() + " is not positive",
                                 "give P > 0");
            }
        }
        return drawn;
    });
    if (!family.has("friction")) {
        return; // the members of a union are tried as families of their own
    }
    std::set<std::string> tried;
    for (const SceneSpec& scene : scenes) {
        if (tried.insert(scene.text()).second) {
            io::at_place(file, family.lines.at("friction"), [&] { require_partial_slip(scene); });
        }
    }
}

void collect_words(std::string_view text, std::set<std::string>& into) {
    const auto of_word = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; };
    for (auto it = text.begin(); it != text.end();) {
        const auto end = std::find_if_not(it, text.end(), of_word);
        into.emplace(it, end);
        it = std::find_if(end, text.end(), of_word);
    }
}

namespace {

/// Returns the names that a claim uses, including those in the bodies of its definitions. A name in
/// a field that is not a formula counts as used.
std::set<std::string> names_used(const Claim& claim) {
    std::set<std::string> names;
    for (const auto& [key, field] : claim.fields) {
        if (key == "remark" || key == "over") {
            continue;
        }
        std::ranges::for_each(field.texts(), [&](const auto& text) { collect_words(text, names); });
    }
    for (std::size_t before = 0; before != names.size();) {
        before = names.size();
        for (const auto& definition : claim.vocabulary.definitions) {
            if (names.contains(definition.name)) {
                names.merge(free_symbols(definition.body));
            }
        }
    }
    return names;
}

/// Names that other programs, or scenes, use for a parameter of a family.
constexpr std::pair<std::string_view, std::string_view> other_names[] = {{"mu", "friction"},
                                                                         {"f", "friction"},
                                                                         {"bulk_tension", "sig0"},
                                                                         {"tension", "sig0"},
                                                                         {"contact_modulus", "Es"}};

/// True for the contacts whose traction under full stick is known.
bool can_stick(const Family& family) {
    return !family.axisymmetric() && !is_flat_punch(family.profile);
}

std::string instead_of_unused(const Family& family, const std::string& name) {
    if (can_stick(family) && (name == "Q" || name == "sig0") &&
        !family.has(name == "Q" ? "sig0" : "Q")) {
        return "add " + std::string(name == "Q" ? "sig0" : "Q") +
               ", without which there is no shear traction, or leave " + name + " out";
    }
    for (const auto& [other, own] : other_names) {
        if (name == other) {
            return "write " + std::string(own) + " if it is meant, or leave " + name + " out";
        }
    }
    return "leave it out";
}

/// `names`: the names used by the claims over the family.
void refuse_unused_of(const Family& family, std::set<std::string> names, const std::string& file) {
    if (std::ranges::any_of(names, is_stress) || names.contains("greatest") ||
        names.contains("axis")) {
        names.insert("nu");
    }
    const std::vector<std::string_view> of_contact = keys_of_contact(family);
    names.insert(of_contact.begin(), of_contact.end());
    if (is_flat_punch(family.profile)) {
        names.insert("P");
    } else if (family.has("Q") &&
               (family.has("friction") || (can_stick(family) && family.has("sig0")))) {
        names.insert({"Q", "sig0", "friction"});
    }
    for (const auto* formulas : {&family.knots, &family.slopes}) {
        for (const Expr& e : *formulas) {
            names.merge(free_symbols(e));
        }
    }
    for (std::size_t before = 0; before != names.size();) {
        before = names.size();
        for (const auto& [name, values] : family.parameters) {
            if (names.contains(name)) {
                for (const Expr& value : values) {
                    names.merge(free_symbols(value));
                }
            }
        }
    }
    for (const auto& [name, values] : family.parameters) {
        if (!names.contains(name)) {
            throw InputError("the parameter " + name + " of family " + family.name +
                                 " has no effect: neither the profile " + family.profile +
                                 " nor another parameter nor a claim over the family uses it",
                             instead_of_unused(family, name))
                .at(file, family.lines.at(name));
        }
    }
}

} // namespace

void refuse_unused_parameters(const Ledger& ledger) {
    std::map<std::string, std::set<std::string>> used;
    const auto add = [&](const Claim& claim, const std::set<std::string>& names) {
        if (claim.has("over")) {
            for (const Family* family : ledger.members(ledger.family(claim.text("over")))) {
                used[family->name].insert(names.begin(), names.end());
            }
        }
    };
    for (const Claim& claim : ledger.claims) {
        add(claim, names_used(claim));
        for (const Claim& reading : claim.readings) {
            add(reading, names_used(reading));
        }
        for (const LaterResult& later : ledger.later) {
            if (later.claim == claim.id) {
                add(claim, free_symbols(later.says));
            }
        }
    }
    for (const Family& family : ledger.families) {
        if (family.union_of.empty()) {
            refuse_unused_of(family, used[family.name], ledger.file);
        }
    }
}

} // namespace edgeproof::audit
