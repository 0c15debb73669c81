// SPDX-License-Identifier: BSD-3-Clause
// Scene of edgeproof.hpp: texts become the types of the library, and back.
#include "edgeproof/interface/enclosed_value.hpp"
#include "edgeproof/io/text_file.hpp"
#include "edgeproof/report/figures/scene_figure.hpp"
#include "edgeproof/scene/binary64_values.hpp"
#include "edgeproof/scene/input/readers.hpp"
#include "edgeproof/scene/input/scene_words.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <tuple>

namespace edgeproof {
namespace {

using Texts = std::vector<std::string>;

constexpr long most_digits_of_values = 10'000;
constexpr long most_terms = 400;

scene::AskedValue asked_of(const Query& query, const scene::Place::Names& names) {
    static constexpr std::string_view keys[] = {"u",    "x",         "edge",     "at",
                                                "body", "tolerance", "reference"};
    std::map<std::string, std::string> where;
    for (const std::string_view given : io::split_words(query.where)) {
        const std::string word(given);
        const std::size_t equals = std::min(word.find('='), word.size());
        const std::string key = word.substr(0, equals);
        require(equals < word.size() && std::ranges::find(keys, key) != std::end(keys),
                "'" + word + "' is no place of " + query.quantity,
                "write u=, x=, edge=, at=X,Z, body=, tolerance= or reference=");
        where[key] = word.substr(equals + 1);
    }
    return scene::asked_value(query.quantity, where, names);
}

scene::BoundedValue bounded(scene::SceneValues& solved, const scene::AskedValue& asked,
                            unsigned digits) {
    if (scene::row_of(asked.quantity).searched && asked.quantity != scene::Quantity::extent) {
        const scene::Row& found = solved.searched(asked);
        if (!found.value || !found.reached) {
            throw DomainError("there is no " + text_of(asked) +
                              ": the terms stay within the "
                              "tolerance");
        }
        return *found.value;
    }
    if (const auto outside = value_outside(asked.quantity, formula::bits_for(digits))) {
        try {
            scene::AskedValue place = asked;
            place.quantity = scene::Quantity::x;
            (void)solved.value(place);
        } catch (const scene::OutsideContact&) {
            return *outside;
        }
    }
    return solved.value(asked);
}

std::vector<io::TomlEntry> entries_of(const Keys& keys) {
    std::vector<io::TomlEntry> entries;
    for (const auto& [key, value] : keys) {
        std::visit([&, &name = key](const auto& v) { entries.push_back({name, v}); }, value);
    }
    return entries;
}

/// Takes a key out of a question; the default where it is not given.
template <class T> T taken(Keys& asked, std::string_view key, T value) {
    const auto found = std::ranges::find(asked, key, &Keys::value_type::first);
    if (found != asked.end()) {
        value = std::get<T>(found->second);
        asked.erase(found);
    }
    return value;
}

template <class List, class Text> Json list_of(const List& list, const Text& text) {
    Json all = Json::array();
    for (const auto& item : list) {
        all.push_back(text(item));
    }
    return all;
}

template <class T> Json or_null(const std::optional<T>& value) {
    return value ? Json(*value) : Json(nullptr);
}

scene::Body body_of(bool body_B) { return body_B ? scene::Body::B : scene::Body::A; }

/// Returns a place x as a number if it is one, else as it was written.
std::string place_text(const scene::AskedPoint& point) {
    const auto number = point.place ? point.place->number() : std::nullopt;
    return number ? number->text() : point.text();
}

Json row_of(const scene::Scene& scene, const scene::Row& row) {
    const scene::AskedValue& asked = row.asked;
    const scene::QuantityRow& def = scene::row_of(asked.quantity);
    const bool covers = asked.quantity == scene::Quantity::extent && scene.ask.process_zone;
    using Place = scene::QuantityRow::Place;
    static constexpr std::array places{"contact", "edge", "point", "body", "surface"};
    static_assert(static_cast<std::size_t>(Place::surface) + 1 == places.size());
    static constexpr std::array states{"stick", "slip", "undecided"};
    using contact::SlipState;
    static_assert(static_cast<std::size_t>(SlipState::undecided) + 1 == states.size());
    return {
        def.symbol.empty() ? def.label : def.symbol,
        asked.k,
        asked.j,
        places.at(static_cast<std::size_t>(def.place)),
        scene::edge_name(asked.edge),
        def.at_point() || def.of_bodies() ? Json(row.point) : Json(nullptr),
        asked.u ? Json(asked.u->text()) : Json(nullptr),
        row.value
            ? Json(value_of(*row.value, digits_of(asked.quantity, scene.ask.digits).count).state())
            : Json(nullptr),
        row.reached,
        row.state ? Json(states.at(static_cast<std::size_t>(*row.state))) : Json(nullptr),
        covers ? Json(covers_zone(scene, *row.value)) : Json(nullptr)};
}

} // namespace

struct Scene::Solved {
    Solved(scene::Scene of, std::string of_text) : scene(std::move(of)), text(std::move(of_text)) {}

    scene::Scene scene;
    std::string text;
    using Contacts = std::vector<std::unique_ptr<scene::Binary64Values>>;
    /// Contacts that no thread uses, for the next arrays: solving one takes longer than a value.
    mutable std::mutex mutex;
    mutable std::map<std::tuple<scene::Quantity, std::size_t, bool>, Contacts> free;

    [[nodiscard]] std::vector<Value> values(const std::vector<Query>& queries,
                                            unsigned digits) const {
        require_digits(digits, 2, most_digits_of_values);
        const scene::Place::Names names = scene::names_of(scene);
        std::vector<scene::AskedValue> asked;
        std::vector<scene::AskedValue> together; // a solved scene has one tolerance, one reference
        for (const Query& query : queries) {
            asked.push_back(asked_of(query, names));
            if (const auto lack = lack_of(scene, asked.back())) {
                throw InputError(lack->problem, lack->instead);
            }
            if (!asked.back().tolerance && !asked.back().reference) {
                together.push_back(asked.back());
            }
        }
        std::optional<scene::SceneValues> shared;
        if (!together.empty()) {
            shared.emplace(scene, together, scene::Digits{digits});
        }
        std::vector<Value> values;
        for (const scene::AskedValue& one : asked) {
            std::optional<scene::SceneValues> own;
            if (one.tolerance || one.reference) {
                own.emplace(scene, std::vector{one}, scene::Digits{digits});
            }
            values.push_back(value_of(bounded(own ? *own : *shared, one, digits),
                                      digits_of(one.quantity, scene::Digits{digits}).count));
        }
        return values;
    }
    void array(const scene::Binary64Question& question, contact::Edge edge,
               std::span<const double> places, std::span<double> values) const {
        if (places.size() != values.size()) {
            throw Error("the places and the values differ in number");
        }
        const std::tuple key(question.quantity, question.n, question.from_origin);
        std::unique_ptr<scene::Binary64Values> contact;
        {
            const std::lock_guard lock(mutex);
            Contacts& unused = free[key];
            if (!unused.empty()) {
                contact = std::move(unused.back());
                unused.pop_back();
            }
        }
        if (!contact) {
            contact = std::make_unique<scene::Binary64Values>(scene, question);
        }
        (*contact)(edge, places, values);
        const std::lock_guard lock(mutex);
        free[key].push_back(std::move(contact));
    }
    /// The scene with these keys of [ask] in place of its own.
    [[nodiscard]] scene::Scene asking(Keys asked) const {
        const Texts x = taken<Texts>(asked, "points_x", {});
        const Texts z = taken<Texts>(asked, "points_z", {});
        const scene::Body body = scene::body_named(taken<std::string>(asked, "body", "A"));
        scene::Scene changed = scene;
        for (const auto& [key, value] : asked) {
            if (key == "quantities") {
                changed.ask.quantities.clear();
            } else if (key == "tolerance") {
                changed.ask.tolerance.reset();
            } else if (key == "process_zone") {
                changed.ask.process_zone.reset();
            }
        }
        try {
            const auto top = io::TomlSection::made({{"ask", 0, entries_of(asked)}}, scene.file);
            read_ask(top.section("ask"),
                     io::TomlSection::parse(text, scene.file).section("profile"), changed);
        } catch (const InputError& error) {
            throw InputError(error.problem(), error.instead()); // the questions are in no file
        }
        changed.ask.digits = {changed.ask.digits.count, Rounding::nearest, true};
        changed.ask.surface_of = body;
        if (!x.empty()) {
            const scene::Place::Names names = scene::names_of(changed);
            changed.ask.in_bodies.clear();
            for (std::size_t i = 0; i < x.size(); ++i) {
                changed.ask.in_bodies.push_back(scene::body_point(x[i], z.at(i), body, names));
            }
        }
        return changed;
    }
};

const scene::Scene& scene_of(const Scene& scene) { return scene.solved().scene; }

Scene::Scene(const std::string& words) {
    const std::vector<std::string_view> parts = std::filesystem::exists(words)
                                                    ? std::vector<std::string_view>{words}
                                                    : io::split_words(words);
    const scene::GivenScene given = scene::given_scene({parts.begin(), parts.end()});
    if (given.file.empty()) {
        solved_ = std::make_shared<Solved>(scene::parse_scene("", "scene", given.instead),
                                           scene::scene_text(given.instead));
    } else {
        solved_ = std::make_shared<Solved>(scene::read_scene(given.file, given.instead), "");
    }
}
Scene Scene::from_text(const std::string& text, const std::string& file) {
    return Scene(std::make_shared<Solved>(scene::parse_scene(text, file), text));
}
Scene Scene::from_keys(const std::vector<std::pair<std::string, Keys>>& sections,
                       const std::string& title) {
    std::vector<io::TomlTable> tables;
    for (const auto& [name, keys] : sections) {
        tables.push_back({name, 0, entries_of(keys)});
    }
    return Scene(std::make_shared<Solved>(scene::make_scene(tables, title),
                                          scene::scene_text(tables, title)));
}
const std::string& Scene::text() const { return solved_->text; }

std::string Scene::facts() const {
    const scene::Scene& s = solved_->scene;
    const Json asked{
        {"quantities", list_of(s.ask.quantities, scene::group_name)},
        {"edges", list_of(s.ask.edges, scene::edge_name)},
        {"terms", s.ask.terms},
        {"u", list_of(s.ask.u, [](const scene::AskedPoint& point) { return point.text(); })},
        {"tolerance", s.ask.tolerance ? Json(s.ask.tolerance->text()) : Json(nullptr)},
        {"digits", s.ask.digits.count}};
    return json_text(
        {{"file", s.file},
         {"title", s.title},
         {"symmetric", s.symmetric()},
         {"has_shear", s.shear.has_value()},
         {"slips", s.slips()},
         {"integrated", !s.closed()},
         {"mises", {s.poisson(scene::Body::A).has_value(), s.poisson(scene::Body::B).has_value()}},
         {"asked", asked}});
}

std::string Scene::run(const Keys& asked) const {
    const scene::Scene scene = solved_->asking(asked);
    const scene::SceneResult result = run_scene(scene);
    const auto point = [](const scene::BodyPoint& p) {
        return Json{p.body == scene::Body::A ? "A" : "B", p.x.text(), p.z.text()};
    };
    return json_text(
        {{"rows", list_of(result.rows, [&](const scene::Row& row) { return row_of(scene, row); })},
         {"points", list_of(scene.ask.in_bodies, point)},
         {"places", list_of(scene.ask.u, place_text)},
         {"s_half_powers", scene::shear_half_powers(scene)},
         {"in_proportion", result.in_proportion},
         {"proved", std::ranges::all_of(result.rows, [](const scene::Row& row) {
              return !row.value || row.value->proved;
          })}});
}

std::string Scene::pictures(const Keys& asked, const std::string& field, bool body_B) const {
    const auto number = [](const Real& x) { return x.convert_to<double>(); };
    const auto axis = [&](const report::Axis& of) {
        return Json{of.label, of.logarithmic,
                    of.range ? Json{number(of.range->first), number(of.range->second)}
                             : Json(nullptr)};
    };
    const scene::Scene scene = solved_->asking(asked);
    Json panels = Json::array();
    for (const report::Plot& plot :
         field.empty() ? report::scene_picture(scene, [](std::size_t, std::size_t) {})
                       : std::vector{report::stress_picture(scene, field, body_of(body_B))}) {
        Json panel{{"title", plot.title}, {"x", axis(plot.x)}, {"y", axis(plot.y)}};
        if (const auto& f = plot.field) {
            panel["field"] = {{"x", f->x},
                              {"z", f->y},
                              {"values", f->values},
                              {"title", f->title},
                              {"signed", f->is_signed},
                              {"contact", f->contact},
                              {"stick", or_null(f->stick)},
                              {"unbounded", f->is_unbounded}};
        }
        Json curves = Json::array();
        for (std::size_t i = 0; i < plot.curves.size(); ++i) {
            Json x = Json::array();
            Json y = Json::array();
            for (const auto& row : plot.rows) {
                if (const auto& value = row[i + 1]) {
                    x.push_back(number(*row[0]));
                    y.push_back((plot.y.percent ? 100 : 1) * number(*value));
                }
            }
            const auto& [column, title, pen, marks] = plot.curves[i];
            curves.push_back({title, static_cast<int>(pen.colour), pen.dash, or_null(pen.point),
                              pen.width, x, y, or_null(marks)});
        }
        panel["curves"] = curves;
        panel["level"] =
            plot.level ? Json{number(plot.level->first), plot.level->second} : Json(nullptr);
        panels.push_back(panel);
    }
    return json_text(panels);
}

std::string Scene::greatest(const std::string& quantity, bool body_B, unsigned digits) const {
    require_digits(digits, 2, most_digits_of_values);
    scene::Scene scene = solved_->scene;
    scene.ask.digits = {digits, Rounding::nearest, true};
    const scene::GreatestValue found =
        scene::greatest_value(scene, scene::greatest_of(quantity), body_of(body_B));
    const auto state = [&](const scene::BoundedValue& v) { return value_of(v, digits).state(); };
    return json_text({{"value", state(found.value)},
                      {"x", state(found.x)},
                      {"z", state(found.z)},
                      {"notes", found.notes}});
}

std::string Scene::stress_terms(const Keys& asked, const std::string& angle, bool body_B) const {
    const scene::Scene scene = solved_->asking(asked);
    const auto term = [&](const scene::RayTerm& t) {
        return Json{scene::edge_name(t.edge), t.halves,
                    list_of(t.values, [&](const scene::BoundedValue& v) {
                        return value_of(v, scene.ask.digits.count).state();
                    })};
    };
    return json_text(list_of(
        scene::ray_terms(scene, body_of(body_B), scene::parse_angle(angle), scene.ask.most_terms()),
        term));
}

void Scene::binary64(const std::string& quantity, long n, const std::string& edge, bool by_x,
                     std::span<const double> places, std::span<double> values) const {
    using scene::Quantity;
    static const std::map<std::string, Quantity> named{
        {"p", Quantity::p}, {"q", Quantity::q}, {"local", Quantity::local}, {"rel", Quantity::rel}};
    require(n >= 0 && n <= most_terms, "terms = " + std::to_string(n) + " is out of range",
            "give a number from 1 to " + std::to_string(most_terms));
    solved_->array({named.at(quantity), static_cast<std::size_t>(n), by_x}, scene::edge_of(edge),
                   places, values);
}

Value Scene::value(const std::string& quantity, const std::string& where, unsigned digits) const {
    return solved_->values({{quantity, where}}, digits).front();
}
std::vector<Value> Scene::values(const std::vector<Query>& queries, unsigned digits) const {
    return solved_->values(queries, digits);
}
void Scene::pressures(std::span<const double> x, std::span<double> p) const {
    binary64("p", 0, "right", true, x, p);
}
void Scene::shears(std::span<const double> x, std::span<double> q) const {
    binary64("q", 0, "right", true, x, q);
}
void Scene::stresses(std::span<const double> x, std::span<const double> z, const Stresses& at,
                     bool body_B) const {
    const std::span<double> mises = at.mises.empty() ? at.sxx : at.mises;
    for (const std::span<double> array : {at.sxx, at.szz, at.sxz, at.tau_max, mises, at.bound}) {
        if (x.size() != z.size() || array.size() != x.size()) {
            throw Error("the places and the values differ in number");
        }
    }
    compute_binary64(solved_->scene, body_of(body_B), x, z,
                     {{at.sxx, at.szz, at.sxz, at.tau_max, at.mises}, at.bound});
}

} // namespace edgeproof
