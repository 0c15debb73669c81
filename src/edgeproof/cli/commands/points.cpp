// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cli/scene_command.hpp"
#include "edgeproof/report/tables/reference_table.hpp"

namespace edgeproof::cli {
namespace {

int points(const SceneOptions& o) {
    const conformance::Recipe recipe =
        conformance::read_recipe(file_or_shipped(o.scene, shipped_recipes));
    emit(report::question_table(o.exact ? recipe.questions : rounded_to_binary64(recipe.questions),
                                recipe.title),
         o);
    return 0;
}

} // namespace

void add_points(CLI::App& app, int& code) {
    auto [sub, o] = add_command<SceneOptions>(app, code, "points",
                                              "the questions of a recipe, to be answered", points);
    sub.add_option("recipe", o.scene, "the recipe (TOML)")->required();
    sub.add_option("--out", o.out, "write to this file, whole or not at all");
    sub.add_flag("--no-notes", o.no_notes, "leave out the facts and notes behind the rows");
    sub.add_flag("--exact", o.exact,
                 "numbers as the recipe gives them (default: rounded to binary64, so that a "
                 "program reads them exactly)");
}

} // namespace edgeproof::cli
