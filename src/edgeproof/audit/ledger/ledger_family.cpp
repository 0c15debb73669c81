// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/ledger/ledger_family.hpp"

#include "edgeproof/formula/parse.hpp"
#include "edgeproof/io/error_place.hpp"
#include "edgeproof/io/toml/toml_section.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <string_view>

namespace edgeproof::audit {
namespace {

class FamilyReader {
public:
    FamilyReader(const io::TomlSection& table, const std::string& file)
        : table_(table), file_(file) {
        table_.allow(
            {"name", "profile", "parameters", "knots", "slopes", "u", "count", "points", "union"});
        family_.line = table_.line();
        family_.name = table_.written("name");
    }

    Family read(const std::vector<Family>& above) {
        const auto is_above = [&](const std::string& name) {
            return std::any_of(above.begin(), above.end(),
                               [&](const Family& f) { return f.name == name; });
        };
        if (is_above(family_.name)) {
            table_.reject("name", "the family " + family_.name + " stands twice",
                          "give each family a name of its own");
        }
        if (!table_.has("union")) {
            read_own();
            return std::move(family_);
        }
        table_.allow({"name", "union", "count"});
        family_.union_of = table_.written_list("union");
        family_.count = table_.has("count") ? table_.count("count", 1, most_scenes) : 0;
        for (const std::string& member : family_.union_of) {
            if (!is_above(member)) {
                table_.reject("union", "there is no family '" + member + "' above",
                              "name families that stand above the union");
            }
        }
        return std::move(family_);
    }

private:
    static constexpr std::size_t most_scenes = 1000000;
    static constexpr std::size_t most_points = 10000;

    void read_own() {
        family_.profile = table_.written("profile");
        const std::size_t longest = read_parameters();
        formula::Symbols with_x = names_;
        with_x.add("x");
        family_.knots = formulas("knots", names_);
        family_.slopes = formulas("slopes", with_x);
        read_fractions();
        family_.count = table_.has("count") ? table_.count("count", 1, most_scenes)
                                            : std::max<std::size_t>(longest, 8);
        family_.points = table_.has("points") ? table_.count("points", 1, most_points) : 1;
    }

    /// Returns the length of the longest list.
    std::size_t read_parameters() {
        const io::TomlSection parameters = table_.section("parameters");
        for (const std::string& name : parameters.keys()) {
            try {
                names_.add(name);
            } catch (const InputError& error) {
                throw error.at(file_, parameters.line(name));
            }
        }
        std::size_t longest = 1;
        for (const std::string& name : parameters.keys()) {
            std::vector<formula::Expr> values;
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
        for (const std::string_view needed : {"a", "Es"}) {
            if (!names_.has(needed)) {
                table_.reject("parameters",
                              "the family " + family_.name + " has no " + std::string(needed),
                              "add " + std::string(needed) +
                                  " = [\"...\"] to its parameters (a: right edge, Es: E*)");
            }
        }
        return longest;
    }

    void read_fractions() {
        if (!table_.has("u")) {
            return;
        }
        for (const std::string& text : table_.written_list("u")) {
            const formula::Exact u(formula(table_.line("u"), text, {}));
            if (u.sign() <= 0 || formula::Exact(formula::Expr::number(1) - u.expr()).sign() <= 0) {
                table_.reject("u", "the fraction u = " + text + " is not between 0 and 1",
                              "give fractions of the contact's length, such as 1e-3");
            }
            family_.u.push_back(u);
        }
    }

    [[nodiscard]] std::vector<formula::Expr> formulas(std::string_view key,
                                                      const formula::Symbols& symbols) const {
        std::vector<formula::Expr> all;
        if (table_.has(key)) {
            for (const std::string& text : table_.written_list(key)) {
                all.push_back(formula(table_.line(key), text, symbols));
            }
        }
        return all;
    }

    [[nodiscard]] formula::Expr formula(std::size_t line, const std::string& text,
                                        const formula::Symbols& symbols) const {
        try {
            return parse(text, symbols);
        } catch (const InputError& error) {
            throw error.at(file_, line != 0 ? line : table_.line());
        }
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
    try {
        for (const SceneSpec& scene : draw_scenes(family, all)) {
            static_cast<void>(scene.make_profile());
            for (const char* positive : {"a", "Es"}) {
                if (scene.parameter(positive).sign() <= 0) {
                    throw InputError(std::string(positive) + " = " +
                                         scene.parameter(positive).text() + " is not positive",
                                     "give " + std::string(positive) + " > 0");
                }
            }
        }
    } catch (const Error&) {
        io::rethrow_at(file, family.line);
    }
}

} // namespace edgeproof::audit
