// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/conformance/questions/recipe.hpp"

#include "edgeproof/io/error_place.hpp"
#include "edgeproof/io/text_file.hpp"
#include "edgeproof/io/toml/toml_section.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/message.hpp"
#include "edgeproof/scene/input/file_kind.hpp"
#include "edgeproof/scene/input/points.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace edgeproof::conformance {
namespace {

constexpr long most_digits_of_a_recipe = 100'000;

Rounding rounding_of(const io::TomlSection& top) {
    const std::string name = top.text("rounding");
    const auto mode = rounding_named(name);
    if (mode && *mode != Rounding::enclosure) {
        return *mode;
    }
    static constexpr std::array<std::string_view, 3> ways{"nearest", "down", "up"};
    top.reject("rounding", "rounding = \"" + name + "\" is no way to round", one_of(name, ways));
}

GridAxis read_axis(const io::TomlSection& section, const std::string& key) {
    GridAxis axis{key, {}, section.line(key), false};
    if (is_list_key(key)) {
        std::string joined;
        const auto add = [&](const std::string& item) {
            joined += (joined.empty() ? "" : "; ") + item;
        };
        if (key == "slopes") {
            for (const std::string& item : section.texts(key)) {
                add(item);
            }
        } else {
            for (const auto& item : section.exacts(key)) {
                add(item.value.text());
            }
        }
        axis.values = {joined};
    } else if (key == "symmetric") {
        axis.values = {section.flag(key) ? "true" : "false"};
    } else if (is_word_key(key)) {
        axis.values = {section.text(key)};
    } else {
        axis.grid = section.is_list(key);
        for (const auto& item : section.exacts(key)) {
            axis.values.push_back(item.value.text());
        }
    }
    if (axis.values.empty()) {
        section.reject(key, "there is no value of " + key, "give one value or several");
    }
    return axis;
}

std::vector<GridAxis> read_axes(const io::TomlSection& scene) {
    std::vector<GridAxis> axes;
    for (const char* part : {"profile", "load", "shear"}) {
        if (std::string_view(part) == "shear" && !scene.has(part)) {
            continue;
        }
        const io::TomlSection section = scene.section(part);
        std::vector<std::string_view> known;
        for (const std::string_view key : parameter_keys()) {
            if (section_of(key) == part) {
                known.push_back(key);
            }
        }
        section.allow(known);
        for (const std::string& key : section.keys()) {
            axes.push_back(read_axis(section, key));
        }
    }
    return axes;
}

AskedPoints read_points(const io::TomlSection& scene) {
    AskedPoints points;
    if (!scene.has("u")) {
        return points;
    }
    const std::size_t line = scene.line("u");
    const auto check = [&](const formula::Exact& u, std::size_t at) {
        if (u.sign() <= 0) {
            scene.reject(at, "u = " + u.text() + " is not inside the contact",
                         "give distances from the edge, 0 < u < a + b");
        }
    };
    if (!scene.is_table("u")) {
        for (const auto& item : scene.exacts("u")) {
            check(item.value, item.line);
            points.listed.push_back({item.value, item.line});
        }
        return points;
    }
    const io::TomlSection range = scene.section("u");
    range.allow({"from", "to", "per_decade", "points"});
    if (range.has("per_decade") == range.has("points")) {
        scene.reject(line, "a range of u needs one of per_decade and points",
                     "write u = { from = \"1e-12\", to = \"0.9\", per_decade = 5 }");
    }
    const formula::Exact from = range.exact("from");
    const formula::Exact to = range.exact("to");
    points.range_line = line;
    try {
        points.range =
            range.has("per_decade")
                ? scene::PointRange::geometric(from, to, range.count("per_decade", 1, 10'000))
                : scene::PointRange::even(from, to, range.count("points", 2, 100'000));
    } catch (const InputError& error) {
        throw error.file().empty() ? error.at(scene.file(), line) : error;
    }
    check(from, line); // the others are greater
    return points;
}

struct Asked {
    std::vector<contact::Edge> edges;
    AskedPoints u;
    std::vector<scene::NamedQuantity> quantities;
    std::vector<formula::Exact> tolerances;
    std::size_t line = 0; ///< of the quantities
};

std::vector<formula::Exact> read_tolerances(const io::TomlSection& scene) {
    std::vector<formula::Exact> tolerances;
    for (const std::string& text : !scene.has("tolerance") ? std::vector<std::string>{}
                                   : scene.is_list("tolerance")
                                       ? scene.texts("tolerance")
                                       : std::vector{scene.written("tolerance")}) {
        try {
            tolerances.push_back(scene::parse_tolerance(text));
        } catch (const InputError& error) {
            scene.reject("tolerance", error.problem(), error.instead());
        }
    }
    return tolerances;
}

Asked read_asked(const io::TomlSection& scene) {
    Asked asked;
    asked.line = scene.line("quantities");
    for (const std::string& name : scene.texts("quantities")) {
        const auto quantity = scene::quantity_named(name);
        if (!quantity) {
            scene.reject("quantities", "unknown quantity '" + name + "'",
                         scene::quantity_advice(name));
        }
        asked.quantities.push_back(*quantity);
    }
    for (const std::string& name :
         scene.has("edges") ? scene.texts("edges") : std::vector<std::string>{"right"}) {
        const auto edge = scene::edge_named(name);
        if (!edge) {
            scene.reject("edges", "there is no edge '" + name + "'", "write \"right\" or \"left\"");
        }
        asked.edges.push_back(*edge);
    }
    asked.u = read_points(scene);
    asked.tolerances = read_tolerances(scene);
    const auto any = [&](const auto& is) {
        return std::any_of(asked.quantities.begin(), asked.quantities.end(),
                           [&](const scene::NamedQuantity& q) { return is(row_of(q.quantity)); });
    };
    if (asked.tolerances.empty() && any([](const auto& row) { return row.tolerance; })) {
        scene.reject("quantities", "an extent is requested and there is no tolerance",
                     "add tolerance = \"1%\"");
    }
    if (asked.u.size() == 0 && any([](const auto& row) { return row.at_point(); })) {
        scene.reject("quantities", "p or q is requested and there are no points",
                     "add u = [\"1e-3\", \"0.1\"]");
    }
    if (asked.quantities.empty() || asked.edges.empty()) {
        scene.reject(scene.line(), "no quantity or no edge is requested",
                     "add quantities = [\"p\"] and edges = [\"right\"]");
    }
    return asked;
}

/// The questions for one contact, in the order of the rows.
AskedList asked_of_one(const Asked& asked) {
    AskedList list(asked.u);
    /// Makes questions for the quantities with `is(row)`, each a copy of `like`.
    const auto questions = [&](const std::string& from, const scene::AskedValue& like,
                               const auto& is) {
        std::vector<Question> found;
        for (const scene::NamedQuantity& q : asked.quantities) {
            if (is(row_of(q.quantity))) {
                scene::AskedValue value = like;
                value.quantity = q.quantity;
                value.k = q.k;
                found.push_back({value, from + ":" + symbol_of(value), 0, asked.line});
            }
        }
        return found;
    };
    list.add(questions("", {}, [](const auto& row) { return !row.at_edge(); }));
    for (const contact::Edge edge : asked.edges) {
        const std::string from = ":" + scene::edge_name(edge);
        scene::AskedValue value{.edge = edge};
        list.add(questions(from, value, [](const auto& row) {
            return row.at_edge() && !row.at_point() && !row.tolerance;
        }));
        for (const formula::Exact& tolerance : asked.tolerances) {
            value.tolerance = tolerance;
            list.add(questions(from + ":tolerance=" + tolerance.text(), value,
                               [](const auto& row) { return row.tolerance; }));
        }
        value.tolerance.reset();
        list.add_at_points(from + ":u=",
                           questions("", value, [](const auto& row) { return row.at_point(); }));
    }
    return list;
}

} // namespace

RecipeText parse_recipe_text(std::string_view text, const std::string& file) {
    const io::TomlSection top = io::TomlSection::parse(text, file);
    expect_file_kind(top, scene::FileKind::recipe);
    top.allow({"title", "digits", "rounding", "scenes"});
    RecipeText recipe;
    recipe.title = top.has("title") ? top.text("title") : "";
    recipe.digits.binary64 = true;
    if (top.has("digits")) {
        recipe.digits.count =
            static_cast<unsigned>(top.count("digits", 2, most_digits_of_a_recipe));
    }
    if (top.has("rounding")) {
        recipe.digits.rounding = rounding_of(top);
    }
    const io::TomlSection scenes = top.section("scenes");
    for (const std::string& name : scenes.keys()) {
        const io::TomlSection scene = scenes.section(name);
        scene.allow({"profile", "load", "shear", "edges", "u", "tolerance", "quantities"});
        std::vector<GridAxis> axes =
            io::at_place(file, scene.line(), [&] { return read_axes(scene); });
        const Asked asked = io::at_place(file, scene.line(), [&] { return read_asked(scene); });
        recipe.scenes.push_back(
            {name, scene.line(), std::move(axes), asked_of_one(asked), asked.line});
    }
    if (recipe.scenes.empty()) {
        top.reject(scenes.line(), "the recipe has no questions", "add [scenes.NAME]");
    }
    return recipe;
}

Recipe parse_recipe(std::string_view text, const std::string& file) {
    const RecipeGrid grid = RecipeGrid::parse(text, file);
    return {file, grid.title(), grid.digits(), grid.questions()};
}

Recipe read_recipe(const std::filesystem::path& file) {
    const RecipeGrid grid = RecipeGrid::read(file);
    return {io::input_name(file), grid.title(), grid.digits(), grid.questions()};
}

} // namespace edgeproof::conformance
