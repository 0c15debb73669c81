// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cli/scene_command.hpp"

#include <cstdio>
#include <optional>

namespace edgeproof::cli {
namespace {

constexpr std::size_t most_said = 20;

struct TableOptions : OutputOptions {
    std::string recipe;
    std::string threads;
    std::string every;
    std::string part;
    std::vector<std::string> merge;
    bool check = false;
    bool questions = false;
    bool exact = false;
};

std::vector<conformance::Reference> reference_values(const TableOptions& o,
                                                     const conformance::Recipe& recipe,
                                                     const conformance::Questions& some) {
    conformance::ReferenceOptions options;
    options.digits = recipe.digits;
    options.threads = threads_of(o.threads);
    return with_progress("values", options.progress, [&] { return references(some, options); });
}

/// Returns the file of the table: --out, else next to the recipe.
std::filesystem::path table_of(const TableOptions& o) {
    return o.out.empty() ? std::filesystem::path(o.recipe).replace_extension(".csv")
                         : std::filesystem::path(o.out);
}

int check(const TableOptions& o, const conformance::Recipe& recipe) {
    const std::filesystem::path file = table_of(o);
    const io::Csv old = io::parse_csv(io::read_text(file, "table (CSV)"), file.string());
    const std::size_t every =
        o.every.empty() ? 1 : whole_number("--every", o.every, 1, 1'000'000'000);
    conformance::Questions some = recipe.questions;
    some.list.clear();
    for (std::size_t i = 0; i < recipe.questions.list.size(); i += every) {
        some.list.push_back(recipe.questions.list[i]);
    }
    const report::Table made =
        report::reference_table(recipe, some, reference_values(o, recipe, some));
    const auto said = table_differences(old, made, every > 1);
    for (std::size_t i = 0; i < said.size() && i < most_said; ++i) {
        std::fprintf(stderr, "%s\n", said[i].c_str());
    }
    if (said.size() > most_said) {
        std::fprintf(stderr, "and %zu more\n", said.size() - most_said);
    }
    if (said.empty()) {
        std::printf("%s: %zu of %zu rows made anew, every digit the same\n", file.c_str(),
                    made.rows.size(), old.rows.size());
    }
    return said.empty() ? 0 : 1;
}

/// Makes the rows of a part, unless the file holds them already.
int make_part(const TableOptions& o, const conformance::Recipe& recipe) {
    const report::PartOfTable part = report::part_named(o.part, o.recipe);
    if (report::is_complete_part(o.out, part)) {
        std::fprintf(stderr, "%s: part %s is complete\n", o.out.c_str(), o.part.c_str());
        return 0;
    }
    conformance::Questions some = recipe.questions;
    some.list.clear();
    for (std::size_t i = part.number - 1; i < recipe.questions.list.size(); i += part.of) {
        some.list.push_back(recipe.questions.list[i]);
    }
    report::Table table = report::reference_table(recipe, some, reference_values(o, recipe, some));
    for (report::Fact& fact : report::facts_of(part)) {
        table.facts.push_back(std::move(fact));
    }
    emit(table, o);
    return 0;
}

int table(TableOptions& o) {
    (void)format_of(o.format);
    const auto need = [](bool fulfilled, const std::string& problem, const std::string& instead) {
        if (!fulfilled) {
            throw InputError(problem, instead);
        }
    };
    need(o.merge.empty() != o.recipe.empty(), "a table has one recipe, or parts to merge",
         "write edgeproof table RECIPE, or edgeproof table --merge PART... --out FILE");
    need(o.every.empty() || o.check, "--every " + o.every + " takes a sample of a check",
         "add --check");
    need((o.part.empty() && o.merge.empty()) || !o.check, "--check compares a whole table",
         "leave --check out");
    if (!o.out.empty() && !o.check) {
        io::check_output(o.out);
    }
    if (!o.merge.empty()) {
        io::write_output(o.out.empty() ? "-" : o.out, report::merged_parts(o.merge));
        return 0;
    }
    o.recipe = file_or_shipped(o.recipe, shipped_recipes);
    conformance::Recipe recipe = conformance::read_recipe(o.recipe);
    if (o.questions) {
        emit(report::question_table(
                 o.exact ? recipe.questions : rounded_to_binary64(recipe.questions), recipe.title),
             o);
        return 0;
    }
    recipe.digits.exact = o.exact;
    if (o.check) {
        return check(o, recipe);
    }
    if (!o.part.empty()) {
        need(!o.out.empty() && o.out != "-" && format_of(o.format) == report::TableFormat::csv &&
                 !o.no_notes,
             "--part writes a file in CSV, with its notes", "add --out FILE.csv");
        return make_part(o, recipe);
    }
    emit(report::reference_table(recipe, recipe.questions,
                                 reference_values(o, recipe, recipe.questions)),
         o);
    return 0;
}

} // namespace

void add_table(CLI::App& app, int& code) {
    auto [sub, o] = add_command<TableOptions>(app, code, "table", table);
    option(sub, "recipe", o.recipe);
    option(sub, "--out", o.out);
    option(sub, "--format", o.format);
    option(sub, "--no-notes", o.no_notes);
    option(sub, "--questions", o.questions);
    option(sub, "--exact", o.exact);
    option(sub, "--threads", o.threads);
    option(sub, "--part", o.part);
    option(sub, "--merge", o.merge);
    option(sub, "--check", o.check);
    option(sub, "--every", o.every);
}

// The older name of table --questions.
void add_points(CLI::App& app, int& code) {
    auto [sub, o] = add_command<TableOptions>(app, code, "points", [](TableOptions& p) {
        p.questions = true;
        return table(p);
    });
    option(sub, "recipe", o.recipe);
    option(sub, "--out", o.out);
    option(sub, "--no-notes", o.no_notes);
    option(sub, "--exact", o.exact);
}

} // namespace edgeproof::cli
