// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/conformance/questions/question.hpp"
#include "edgeproof/io/text_file.hpp"
#include "edgeproof/io/toml/toml_section.hpp"
#include "edgeproof/io/toml/toml_text.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/message.hpp"
#include "edgeproof/precision/rounding/text.hpp"
#include "edgeproof/scene/input/readers.hpp"
#include "edgeproof/scene/route/scene_values.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <set>
#include <utility>

namespace edgeproof::conformance {
namespace {

/// A parameter of a recipe's scene and its values.
struct GridAxis {
    std::string key;
    std::vector<std::string> values;
    std::size_t line = 0;
    bool grid = false; ///< part of the id
};

/// A scene of a recipe; every contact of its grid has the same questions.
struct GridScene {
    std::string name;
    io::TomlSection section;
    std::vector<GridAxis> axes;
};

constexpr long most_digits_of_a_recipe = 100'000;
constexpr unsigned digits_of_places = 12; ///< of those in edges that are solved for

Rounding rounding_of(const io::TomlSection& top) {
    const std::string name = top.text("rounding");
    if (const auto mode = rounding_named(name)) {
        return *mode;
    }
    static constexpr std::array<std::string_view, 3> ways{"nearest", "down", "up"};
    top.reject("rounding", "rounding = \"" + name + "\" is no way to round", one_of(name, ways));
}

std::vector<formula::Exact> read_range(const io::TomlSection& section, const std::string& key) {
    return scene::points_of_range(section, key, false,
                                  [](const auto& range, auto end) { return range.exact(end); });
}

GridAxis read_axis(const io::TomlSection& section, const std::string& key) {
    GridAxis axis{key, {}, section.line(key), false};
    Parameter parameter{key, {}};
    std::vector<std::string> values;
    if (key == "slopes") {
        values = section.texts(key);
    } else if (key == "symmetric") {
        values = {section.flag(key) ? "true" : "false"};
    } else if (parameter.is_word()) {
        values = {section.text(key)};
    } else if (section.is_table(key) && !parameter.is_list()) {
        axis.grid = true;
        for (const formula::Exact& value : read_range(section, key)) {
            values.push_back(value.text());
        }
    } else {
        axis.grid = section.is_list(key) && !parameter.is_list();
        for (const auto& item : section.exacts(key)) {
            values.push_back(item.value.text());
        }
    }
    if (parameter.is_list()) {
        parameter.set_items(values);
        values = {parameter.text};
    }
    axis.values = std::move(values);
    section.require(!axis.values.empty(), key, "there is no value of " + key,
                    "give one value or several");
    return axis;
}

std::vector<GridAxis> read_axes(const io::TomlSection& scene) {
    std::vector<GridAxis> axes;
    for (const char* part : {"profile", "load", "shear", "steps"}) {
        const std::string_view name(part);
        if ((name == "shear" || name == "steps") && !scene.has(part)) {
            continue;
        }
        const io::TomlSection section = scene.section(part);
        std::vector<std::string_view> known;
        for (const ParameterKey& key : parameter_keys()) {
            if (key.section == part) {
                known.push_back(key.name);
            }
        }
        section.allow(known);
        for (const std::string& key : section.keys()) {
            axes.push_back(read_axis(section, key));
        }
    }
    return axes;
}

/// The points of the bodies: `points` (x, z) in each of the `bodies`, A if none are named.
std::vector<scene::BodyPoint> read_body_points(const io::TomlSection& scene) {
    std::vector<scene::BodyPoint> points;
    for (const std::string& body :
         scene.has("bodies") ? scene.texts("bodies") : std::vector<std::string>{"A"}) {
        scene.require(body == "A" || body == "B", "bodies", "there is no body '" + body + "'",
                      "write \"A\" (on which Q acts) or \"B\"");
        for (const auto& [x, z] : scene.pairs("points")) {
            scene.require(z.value.sign() >= 0, z.line,
                          "the depth z = " + z.value.text() + " is negative",
                          "give points [x, z] with z >= 0, the depth into the body");
            points.push_back({x.value, z.value, body == "A" ? scene::Body::A : scene::Body::B});
        }
    }
    return points;
}

/// Reads the questions for a contact, in the order of the rows; their ids lack the part of the
/// contact.
std::vector<Question> read_asked(const io::TomlSection& scene, const scene::Scene& contact) {
    std::vector<scene::NamedQuantity> quantities;
    const std::size_t line = scene.line("quantities");
    for (const std::string& name : scene.texts("quantities")) {
        const auto quantity = scene::quantity_named(name);
        scene.require(quantity.has_value(), "quantities", "unknown quantity '" + name + "'",
                      scene::quantity_advice(name));
        quantities.push_back(*quantity);
    }
    const std::vector<contact::Edge> edges =
        scene.has("edges") ? scene::read_edges(scene) : std::vector{contact::Edge::right};
    const std::vector<scene::AskedPoint> points = scene::read_places(scene, names_of(contact));
    std::vector<formula::Exact> tolerances;
    if (scene.has("tolerance")) {
        io::at_place(scene.file(), scene.line("tolerance"), [&] {
            std::ranges::transform(scene.written_list("tolerance"), std::back_inserter(tolerances),
                                   scene::parse_tolerance);
        });
    }
    /// Makes questions for the quantities with `is(row)`, each a copy of `like`.
    const auto questions = [&](const std::string& from, const scene::AskedValue& like,
                               const auto& is) {
        std::vector<Question> found;
        for (const scene::NamedQuantity& q : quantities) {
            if (is(row_of(q.quantity))) {
                scene::AskedValue value = like;
                value.quantity = q.quantity;
                value.k = q.k;
                found.push_back({value, from + ":" + symbol_of(value), 0, line});
            }
        }
        return found;
    };
    const auto at_point = [](const auto& row) { return row.at_point(); };
    const auto to_tolerance = [](const auto& row) { return row.tolerance; };
    const auto in_body = [](const auto& row) {
        return row.place == scene::QuantityRow::Place::body;
    };
    const auto require_places = [&](bool given, const auto& is, const char* problem,
                                    const char* instead) {
        scene.require(given || questions("", {}, is).empty(), "quantities", problem, instead);
    };
    require_places(!tolerances.empty(), to_tolerance,
                   "an extent is requested and there is no tolerance", "add tolerance = \"1%\"");
    require_places(!points.empty(), at_point, "p or q is requested and there are no points",
                   "add u = [\"1e-3\", \"0.1\"]");
    scene.require(!quantities.empty(), scene.line(), "no quantity is requested",
                  "add quantities = [\"p\"]");
    require_places(scene.has("points"), in_body, "a stress is requested and there are no points",
                   "add points = [[\"0\", \"1/2\"]] (x, z)");
    // A place that depends on edges which are solved for is rounded: programs read numbers.
    std::optional<scene::SceneValues> values;
    const auto solved = [&](const scene::Distance& distance) {
        const scene::AskedValue a{scene::Quantity::a};
        if (!values) {
            values.emplace(contact, std::vector{a}, scene::Digits{2 * digits_of_places});
        }
        const Ball edge = values->value(a).value;
        const Ball u =
            distance.enclosure(edge, values->value({scene::Quantity::b}).value, edge.bits());
        return certainly_positive(u) ? std::optional(formula::Exact::parse(
                                           to_decimal(u.midpoint(), digits_of_places)))
                                     : std::nullopt;
    };
    std::vector<Question> list;
    const auto add = [&](std::vector<Question> more) {
        std::ranges::move(more, std::back_inserter(list));
    };
    add(questions("", {}, [&](const auto& row) { return !row.at_edge() && !in_body(row); }));
    for (const scene::BodyPoint& point :
         scene.has("points") ? read_body_points(scene) : std::vector<scene::BodyPoint>{}) {
        const scene::AskedValue value{.in_body = point};
        add(questions(std::string(":") + (point.body == scene::Body::A ? "A" : "B") +
                          ":x=" + point.x.text() + ":z=" + point.z.text(),
                      value, in_body));
    }
    for (const contact::Edge edge : edges) {
        const std::string from = ":" + scene::edge_name(edge);
        scene::AskedValue value{.edge = edge};
        add(questions(from, value, [](const auto& row) {
            return row.at_edge() && !row.at_point() && !row.tolerance;
        }));
        for (const formula::Exact& tolerance : tolerances) {
            value.tolerance = tolerance;
            add(questions(from + ":tolerance=" + tolerance.text(), value, to_tolerance));
        }
        value.tolerance.reset();
        for (const scene::AskedPoint& point : points) {
            value.u = point.distance(edge).number();
            value.u = value.u ? value.u : solved(point.distance(edge));
            scene.require(value.u && value.u->sign() > 0, point.line,
                          point.text() + " is not inside the contact",
                          "give places of the contact, off its edges");
            const std::string text = point.text();
            const std::string place =
                point.place && point.place->from() == scene::Place::From::origin
                    ? ":x=" + text.substr(text.find('=') + 2)
                    : ":u=" + text;
            for (Question& q : questions(from + place, value, at_point)) {
                q.line = point.line;
                list.push_back(std::move(q));
            }
        }
    }
    return list;
}

constexpr std::size_t most_questions = 1'000'000;

/// Contact number `contact` of a grid, whose last axis varies fastest, and the begin of the ids of
/// its questions.
std::pair<AskedContact, std::string> at_contact(const GridScene& scene, std::size_t contact,
                                                const std::string& file) {
    std::vector<Parameter> parameters;
    std::string id;
    for (auto axis = scene.axes.rbegin(); axis != scene.axes.rend(); ++axis) {
        const std::string& value = axis->values[contact % axis->values.size()];
        contact /= axis->values.size();
        parameters.push_back({axis->key, value, axis->line});
        id.insert(0, axis->grid ? ":" + axis->key + "=" + value : "");
    }
    return {make_asked_contact(std::move(parameters), file, scene.section.line()), scene.name + id};
}

/// The questions of all scenes. Throws InputError for a question asked twice, for one that a
/// contact cannot answer, and for more than a million questions.
Questions questions_of(const std::vector<GridScene>& scenes, const std::string& file) {
    Questions all;
    all.file = file;
    std::set<std::string> ids;
    for (const GridScene& scene : scenes) {
        std::size_t contacts = 1;
        for (const GridAxis& axis : scene.axes) {
            contacts = std::min(contacts * axis.values.size(), most_questions + 1);
        }
        const std::size_t line = scene.section.line("quantities");
        for (std::size_t c = 0; c < contacts; ++c) {
            auto [contact, id] = at_contact(scene, c, file);
            all.contacts.push_back(std::move(contact));
            std::vector<Question> asked = io::at_place(file, scene.section.line(), [&] {
                return read_asked(scene.section, all.contacts.back().scene);
            });
            scene.section.require(all.list.size() + (contacts - c) * asked.size() <= most_questions,
                                  line, "more than a million questions", "split the recipe");
            for (Question& q : asked) {
                if (c == 0) {
                    check_askable(all.contacts.back(), q, file, line);
                }
                q.id.insert(0, id);
                if (!ids.insert(q.id).second) {
                    throw InputError("the question " + q.id + " is asked twice",
                                     "leave one out, or give the second scene another name")
                        .at(file, q.line);
                }
                q.contact = all.contacts.size() - 1;
                all.list.push_back(std::move(q));
            }
        }
    }
    return all;
}

} // namespace

Recipe parse_recipe(std::string_view text, const std::string& file) {
    const io::TomlSection top = io::TomlSection::parse(text, file);
    expect_file_kind(top, scene::FileKind::recipe);
    top.allow({"title", "digits", "rounding", "scenes"});
    Recipe recipe;
    recipe.file = file;
    recipe.title = top.has("title") ? top.text("title") : "";
    recipe.digits.binary64 = true;
    if (top.has("digits")) {
        recipe.digits.count =
            static_cast<unsigned>(top.count("digits", 2, most_digits_of_a_recipe));
    }
    if (top.has("rounding")) {
        recipe.digits.rounding = rounding_of(top);
    }
    const io::TomlSection named = top.section("scenes");
    std::vector<GridScene> scenes;
    for (const std::string& name : named.keys()) {
        const io::TomlSection scene = named.section(name);
        if (name.empty() || std::string_view("=+-@").find(name.front()) != std::string_view::npos ||
            printable(name) != name) {
            top.reject(scene.line(),
                       "the scene name '" + printable(name) +
                           "' is empty, begins with one of = + - @, or has a character that is not "
                           "printed: "
                           "a spreadsheet or a program would change the ids",
                       "write a name of letters and digits");
        }
        scene.allow({"profile", "load", "shear", "steps", "edges", "u", "x", "points", "bodies",
                     "tolerance", "quantities"});
        io::at_place(file, scene.line(), [&] {
            scenes.push_back({name, scene, read_axes(scene)});
        });
    }
    if (scenes.empty()) {
        top.reject(named.line(), "the recipe has no questions", "add [scenes.NAME]");
    }
    recipe.questions = questions_of(scenes, file);
    return recipe;
}

Recipe read_recipe(const std::filesystem::path& file) {
    return parse_recipe(io::read_text(file, "recipe (TOML)", io::most_toml_bytes),
                        io::input_name(file));
}

} // namespace edgeproof::conformance
