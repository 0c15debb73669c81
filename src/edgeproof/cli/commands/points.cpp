// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cli/cli.hpp"
#include "edgeproof/cli/scene_command.hpp"
#include "edgeproof/cli/shipped_file.hpp"
#include "edgeproof/report/tables/reference_table.hpp"

#include <memory>

namespace edgeproof::cli {

void add_points(CLI::App& app, int& code) {
    struct Options {
        std::string recipe;
        std::string out;
        bool exact = false;
    };
    CLI::App* sub = app.add_subcommand("points", "the questions of a recipe, to be answered");
    auto o = std::make_shared<Options>();
    sub->add_option("recipe", o->recipe, "the recipe (TOML)")->required();
    sub->add_option("--out", o->out, "write to this file, whole or not at all");
    sub->add_flag("--exact", o->exact,
                  "numbers as the recipe gives them (default: rounded to binary64, so that a "
                  "program reads them exactly)");
    sub->callback([o, &code] {
        const conformance::Recipe recipe =
            conformance::read_recipe(file_or_shipped(o->recipe, shipped_recipes));
        SceneOptions output;
        output.out = o->out;
        emit(report::question_table(
                 o->exact ? recipe.questions : rounded_to_binary64(recipe.questions), recipe.title),
             output);
        code = 0;
    });
}

} // namespace edgeproof::cli
