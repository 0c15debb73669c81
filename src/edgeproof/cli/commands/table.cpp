// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/cli/scene_command.hpp"

#include <cstdio>
#include <optional>

namespace edgeproof::cli {
namespace {

constexpr std::size_t most_said = 20;

std::vector<conformance::Reference> reference_values(const Options& o,
                                                     const conformance::Recipe& recipe,
                                                     const conformance::Questions& some) {
    conformance::ReferenceOptions options;
    options.digits = recipe.digits;
    options.threads = threads_of(o["--threads"]);
    return with_progress("values", options.progress, [&] { return references(some, options); });
}

/// Returns the file of the table: --out, else next to the recipe.
std::filesystem::path table_of(const Options& o) {
    return o["--out"].empty() ? std::filesystem::path(o["recipe"]).replace_extension(".csv")
                              : std::filesystem::path(o["--out"]);
}

int check_table(const Options& o, const conformance::Recipe& recipe) {
    const std::filesystem::path file = table_of(o);
    const io::Csv old = io::parse_csv(io::read_text(file, "table (CSV)"), file.string());
    const std::size_t every =
        o["--every"].empty() ? 1 : whole_number("--every", o["--every"], 1, 1'000'000'000);
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
int make_part(const Options& o, const conformance::Recipe& recipe) {
    const report::PartOfTable part = report::part_named(o["--part"], o["recipe"]);
    if (report::is_complete_part(o["--out"], part)) {
        std::fprintf(stderr, "%s: part %s is complete\n", o["--out"].c_str(), o["--part"].c_str());
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

} // namespace

int table(Options& o) {
    (void)format_of(o["--format"]);
    const auto need = [](bool fulfilled, const std::string& problem, const std::string& instead) {
        if (!fulfilled) {
            throw InputError(problem, instead);
        }
    };
    need(o.list("--merge").empty() != o["recipe"].empty(),
         "a table has one recipe, or parts to merge",
         "write edgeproof table RECIPE, or edgeproof table --merge PART... --out FILE");
    need(o["--every"].empty() || o.has("--check"),
         "--every " + o["--every"] + " takes a sample of a check", "add --check");
    const bool shaped = o.has("--wide") || !o["--columns"].empty();
    need(!shaped || (o["--part"].empty() && o.list("--merge").empty() && !o.has("--check") &&
                     !o.has("--questions")),
         "--wide and --columns shape a whole table for reading", "leave the other options out");
    need((o["--part"].empty() && o.list("--merge").empty()) || !o.has("--check"),
         "--check compares a whole table", "leave --check out");
    if (!o["--out"].empty() && !o.has("--check")) {
        io::check_output(o["--out"]);
    }
    if (!o.list("--merge").empty()) {
        io::write_output(o["--out"].empty() ? "-" : o["--out"],
                         report::merged_parts(o.list("--merge")));
        return 0;
    }
    o.set("recipe", file_or_shipped(o["recipe"], shipped_recipes));
    conformance::Recipe recipe = conformance::read_recipe(o["recipe"]);
    if (o.has("--questions")) {
        emit(report::question_table(o.has("--exact") ? recipe.questions
                                                     : rounded_to_binary64(recipe.questions),
                                    recipe.title),
             o);
        return 0;
    }
    recipe.digits.exact = o.has("--exact");
    if (o.has("--check")) {
        return check_table(o, recipe);
    }
    if (!o["--part"].empty()) {
        need(!o["--out"].empty() && o["--out"] != "-" &&
                 format_of(o["--format"]) == report::TableFormat::csv && !o.has("--no-notes"),
             "--part writes a file in CSV, with its notes", "add --out FILE.csv");
        return make_part(o, recipe);
    }
    const std::vector<conformance::Reference> values =
        reference_values(o, recipe, recipe.questions);
    report::Table table = o.has("--wide")
                              ? report::wide_table(recipe, values)
                              : report::reference_table(recipe, recipe.questions, values);
    if (!o["--columns"].empty()) { // the checksum is that of all columns
        std::erase_if(table.facts, [](const report::Fact& f) { return f.key == "checksum"; });
    }
    emit(table, o);
    return 0;
}

// The older name of table --questions.
int points(Options& o) {
    o.values["--questions"].flag = true;
    return table(o);
}

} // namespace edgeproof::cli
