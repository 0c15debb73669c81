// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cli/commands/table_in_parts.hpp"
#include "edgeproof/cli/scene_command.hpp"
#include "edgeproof/io/atomic_file.hpp"
#include "edgeproof/io/text_file.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/report/tables/reference_table.hpp"

#include <cstdio>
#include <optional>

namespace edgeproof::cli {
namespace {

constexpr std::size_t most_said = 20;

struct TableOptions : OutputOptions {
    std::string recipe;
    std::string threads;
    std::string every;
    bool check = false;
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

int to_file(const TableOptions& o) {
    const auto processes = launched_together();
    const bool leads = processes == nullptr || processes->number() == 0;
    std::optional<conformance::RecipeGrid> recipe;
    std::optional<TableInParts> table;
    unsigned threads = 0;
    try {
        threads = processes != nullptr && o.threads.empty() ? 1 : threads_of(o.threads);
        recipe = conformance::RecipeGrid::read(o.recipe);
        table.emplace(*recipe, o.out, format_of(o.format), !o.no_notes);
        if (leads) {
            io::check_output(o.out);
            table->open();
        }
    } catch (const Error& error) {
        if (leads && processes != nullptr) {
            dismiss(*processes);
        }
        if (leads) {
            throw;
        }
        follow_failed(*processes, error.what()); // the first process reports it
        return 0;
    }
    if (leads) {
        table->make(threads, processes.get());
    } else {
        table->help(threads, *processes);
        check_interruption(); // also gives this process the status of an interruption
    }
    return 0;
}

int table(TableOptions& o) {
    o.recipe = file_or_shipped(o.recipe, shipped_recipes);
    (void)format_of(o.format);
    if (!o.every.empty() && !o.check) {
        throw InputError("--every " + o.every + " takes a sample of a check", "add --check");
    }
    if (launched_count() > 1 && (o.check || o.out.empty() || o.out == "-")) {
        throw InputError("several processes share the making of a file, and nothing else",
                         "add --out FILE, or start one process");
    }
    if (!o.out.empty() && !o.check) {
        if (o.out != "-" && !io::OutputTarget::of(o.out).special) {
            return to_file(o);
        }
        io::check_output(o.out); // a device has no part file
    }
    conformance::Recipe recipe = conformance::read_recipe(o.recipe);
    if (o.check) {
        return check(o, recipe);
    }
    emit(report::reference_table(recipe, reference_values(o, recipe, recipe.questions)), o);
    return 0;
}

} // namespace

void add_table(CLI::App& app, int& code) {
    auto [sub, o] = add_command<TableOptions>(app, code, "table",
                                              "a table of reference values from a recipe", table);
    sub.add_option("recipe", o.recipe, "the recipe (TOML)")->required();
    sub.add_option("--out", o.out,
                   "write to this file, whole or not at all; what is done of a long table is "
                   "kept next to it (.part), and the same command goes on from there");
    sub.add_option("--format", o.format, "default: csv")->type_name("csv|json|md|tex");
    sub.add_flag("--no-notes", o.no_notes, "leave out the facts and notes around the rows");
    sub.add_option("--threads", o.threads,
                   "threads (default: one a processor; one each of several processes that "
                   "mpirun or srun started)");
    sub.add_flag("--check", o.check,
                 "make the table anew and compare it with --out (default: the .csv next to the "
                 "recipe); exit 1 where a digit differs");
    sub.add_option("--every", o.every, "with --check: every Nth row only");
}

} // namespace edgeproof::cli
