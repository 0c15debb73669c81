// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/formula/parse.hpp"
#include "edgeproof/io/text_file.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/message.hpp"
#include "edgeproof/precision/rounding/text.hpp"
#include "edgeproof/scene/input/readers.hpp"
#include "edgeproof/scene/input/scene_words.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>

namespace edgeproof::scene {
namespace {

constexpr long most_terms_allowed = 400;
constexpr long most_digits = 100'000;

const GroupRow& group_of(const io::TomlSection& ask, const std::string& name) {
    std::vector<std::string_view> names;
    for (const GroupRow& row : group_rows()) {
        if (row.name == name) {
            return row;
        }
        names.push_back(row.name);
    }
    if (const auto named = column_named(name)) { // p_max, c_0, d, ...: as in recipes
        return group_rows()[static_cast<std::size_t>(row_of(named->quantity).group)];
    }
    ask.reject("quantities", "unknown quantity '" + name + "'", one_of(name, names));
}

/// Runs f; its errors get the line of a key.
template <class F> auto at_key(const io::TomlSection& ask, std::string_view key, const F& f) {
    return io::at_place(ask.file(), ask.line(key), f);
}

/// Nothing for the proved routes, "automatic" and "closed-form".
std::optional<Route> route_of(const io::TomlSection& ask, const Scene& scene) {
    const std::string name = ask.text("route");
    for (const Route route : {Route::singular_integral, Route::barber_mossakovskii}) {
        if (name == route_name(route)) {
            return route;
        }
    }
    if (name == "closed-form" && scene.profile && !scene.profile->has_closed_form()) {
        ask.reject("route",
                   scene.round ? "only a power law has its pressure in closed form as an "
                                 "axisymmetric contact"
                               : "only a power law or a piecewise linear g' has its pressure in "
                                 "closed form",
                   "write route = \"automatic\"");
    }
    static constexpr std::array<std::string_view, 4> names{
        "automatic", "closed-form", "singular-integral", "barber-mossakovskii"};
    ask.require(name == names[0] || name == names[1], "route", "unknown route '" + name + "'",
                one_of(name, names));
    return {};
}

/// True if a text contains a name: a percentage, or a word that is neither a function nor a
/// constant. The e of 1e-3 is part of a number.
bool has_names(std::string_view text) {
    const auto part_of_word = [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.';
    };
    for (std::size_t at = 0; at < text.size();) {
        std::size_t end = at;
        while (end < text.size() && part_of_word(text[end])) {
            ++end;
        }
        const std::string_view word = text.substr(at, end - at);
        if (!word.empty() && std::isalpha(static_cast<unsigned char>(word.front())) != 0 &&
            !formula::is_reserved(word)) {
            return true;
        }
        at = end == at ? at + 1 : end;
    }
    return !text.empty() && text.back() == '%';
}

class PlaceReader {
public:
    PlaceReader(const io::TomlSection& section, std::string_view key, Place::From from,
                const Place::Names& names)
        : section_(section), key_(key), from_(from), names_(names) {}

    [[nodiscard]] AskedPoint point(const io::TomlSection::Written& item) const {
        if (from_ == Place::From::edge && !has_names(item.text)) {
            return inside({with_line(item, [&] { return Exact::parse(item.text); }), item.line});
        }
        const Place place = with_line(item, [&] { return Place::parse(item.text, from_, names_); });
        const auto number = with_line(item, [&] { return place.number(); });
        return from_ == Place::From::edge && number ? inside({*number, item.line, {}, item.text})
                                                    : AskedPoint{Exact(), item.line, place};
    }
    /// An end of a range.
    [[nodiscard]] Place place(std::string_view end) const {
        const io::TomlSection::Written item = section_.numbers_written(end).at(0);
        return with_line(item, [&] { return Place::parse(item.text, from_, names_); });
    }
    [[nodiscard]] std::optional<Exact> number(std::string_view end) const {
        const io::TomlSection::Written item = section_.numbers_written(end).at(0);
        return has_names(item.text) ? with_line(item, [&] { return place(end).number(); })
                                    : section_.exact(end);
    }
    [[nodiscard]] AskedPoint inside(AskedPoint point) const {
        section_.require(sign_of(section_, key_, point.u) > 0, point.line,
                         "u = " + point.u.text() + " is not inside the contact",
                         "give distances from the edge, 0 < u < a + b");
        return point;
    }

private:
    template <class Read>
    auto with_line(const io::TomlSection::Written& item, const Read& read) const
        -> decltype(read()) {
        try {
            return read();
        } catch (const InputError& error) {
            throw InputError(std::string(key_) + " = \"" + item.text + "\": " + error.problem(),
                             error.instead())
                .at(section_.file(), item.line);
        } catch (const DomainError& error) {
            section_.reject(item.line,
                            std::string(key_) + " = \"" + item.text + "\": " + error.what(),
                            "write a formula that has a value");
        }
    }

    const io::TomlSection& section_;
    std::string_view key_;
    Place::From from_;
    const Place::Names& names_;
};

void read_range(const io::TomlSection& ask, std::string_view key, Place::From from,
                const Place::Names& names, std::vector<AskedPoint>& points) {
    const bool by_x = from == Place::From::origin;
    const std::size_t line = ask.line(key);
    const io::TomlSection range = ask.section(key);
    const PlaceReader reader(range, by_x ? "x" : "from", from, names);
    const bool ends = range.has("from") && range.has("to") && range.has("points");
    if (ends && !(reader.number("from") && reader.number("to"))) { // they depend on a and b
        const auto last = static_cast<long>(range.count("points", 2, 100'000)) - 1;
        for (long k = 0; k <= last; ++k) {
            points.push_back(
                {Exact(), line,
                 Place::between(reader.place("from"), reader.place("to"), Rational(k, last))});
        }
        return;
    }
    const std::vector<Exact> all =
        points_of_range(ask, key, by_x, [&](const io::TomlSection&, std::string_view end) {
            const auto number = reader.number(end);
            range.require(number.has_value(), end,
                          std::string(end) + " is not a number: it depends on a and b, which are "
                                             "unknown",
                          "give points in place of per_decade, or a list of places");
            return by_x || end == "to" ? *number : reader.inside({*number, line}).u;
        });
    for (std::size_t i = 0; i < all.size(); ++i) {
        points.push_back(by_x ? AskedPoint{Exact(), line, Place::parse(all[i].text(), from, names)}
                              : AskedPoint{all[i], line});
        points.back().computed = i > 0 && i + 1 < all.size();
    }
}

/// The same with the keys of the section of the profile.
Place::Names names_of(const io::TomlSection& profile, const Scene& scene) {
    Place::Names names = names_of(scene);
    for (const std::string& key : profile.keys()) {
        if (key != "kind" && key != "geometry" && key != "knots" && key != "slopes" &&
            key != "symmetric") {
            names.insert_or_assign(key, profile.exact(key).expr());
        }
    }
    return names;
}

} // namespace

std::vector<AskedPoint> read_places(const io::TomlSection& ask, const Place::Names& names) {
    std::vector<AskedPoint> points;
    for (const auto& [key, from] :
         {std::pair{"u", Place::From::edge}, std::pair{"x", Place::From::origin}}) {
        if (!ask.has(key)) {
            continue;
        }
        if (ask.is_table(key)) {
            read_range(ask, key, from, names, points);
            continue;
        }
        const PlaceReader reader(ask, key, from, names);
        for (const io::TomlSection::Written& item : ask.numbers_written(key)) {
            points.push_back(reader.point(item));
        }
    }
    return points;
}

std::vector<Edge> read_edges(const io::TomlSection& section) {
    std::vector<Edge> edges;
    for (const std::string& name : section.texts("edges")) {
        const Edge edge = at_key(section, "edges", [&] { return edge_of(name); });
        section.require(std::ranges::find(edges, edge) == edges.end(), "edges",
                        "the edge '" + name + "' is asked for twice", "name each once");
        edges.push_back(edge);
    }
    section.require(!edges.empty(), "edges", "no edge is asked for", "write \"right\" or \"left\"");
    return edges;
}

Place::Names names_of(const Scene& scene) {
    Place::Names names;
    if (scene.profile) {
        for (const auto& [name, value] : scene.given_profile().parameters()) {
            names.insert_or_assign(name, value.expr());
        }
    }
    if (scene.load.kind == Load::Kind::right_edge && scene.steps.empty() &&
        (!scene.round || scene.load.value.is_rational())) {
        names.insert_or_assign("a", scene.load.value.expr());
    }
    if (scene.symmetric()) {
        const auto a = names.find("a");
        names.insert_or_assign("b", a != names.end() ? a->second : Expr::symbol("a"));
    }
    return names;
}

BodyPoint body_point(const std::string& x, const std::string& z, Body body,
                     const Place::Names& names) {
    const auto read = [&](const char* key, const std::string& text) {
        try {
            return has_names(text) ? Coordinate(Place::parse(text, Place::From::origin, names))
                                   : Coordinate(Exact::parse(text));
        } catch (const InputError& error) {
            throw InputError(std::string(key) + " = \"" + text + "\": " + error.problem(),
                             error.instead());
        }
    };
    BodyPoint point{read("x", x), read("z", z), body};
    require(!point.z.number() || point.z.number()->sign() >= 0,
            "the depth z = " + z + " is negative", "give z >= 0, the depth into the body");
    return point;
}

int sign_of(const io::TomlSection& section, std::string_view key, const Exact& value) {
    return io::at_place(
        section.file(), section.line(key), [&] { return value.sign(); },
        "write " + std::string(key) + " as a simpler number, or 0 where it is zero");
}

void require_positive(const io::TomlSection& section, std::string_view key, const Exact& value,
                      const std::string& instead) {
    section.require(sign_of(section, key, value) > 0, key,
                    std::string(key) + " = " + value.text() + " is not positive", instead);
}

void read_ask(const io::TomlSection& ask, const io::TomlSection& profile, Scene& scene) {
    std::vector<std::string_view> keys = keys_of_section("ask");
    keys.emplace_back("points");
    ask.allow(keys);
    Ask& result = scene.ask;
    scene.ask_line = ask.line();
    if (ask.has("edges")) {
        result.edges = read_edges(ask);
        result.edges_given = true;
    }
    if (ask.has("terms")) {
        result.terms = ask.counts("terms", 1, most_terms_allowed);
    }
    if (ask.has("digits")) {
        result.digits.count = static_cast<unsigned>(ask.count("digits", 2, most_digits));
    }
    if (ask.has("u") || ask.has("x")) {
        result.u = read_places(ask, names_of(profile, scene));
    }
    if (ask.has("points")) {
        result.in_bodies.clear();
        const Place::Names names = names_of(profile, scene);
        for (const auto& [x, z] : ask.pairs_written("points")) {
            result.in_bodies.push_back(io::at_place(ask.file(), z.line, [&, x = x, z = z] {
                return body_point(x.text, z.text, Body::A, names);
            }));
        }
    }
    if (ask.has("tolerance")) {
        result.tolerance =
            at_key(ask, "tolerance", [&] { return parse_tolerance(ask.written("tolerance")); });
    }
    if (ask.has("reference")) {
        const Place::Names names = names_of(profile, scene);
        result.reference = PlaceReader(ask, "reference", Place::From::origin, names)
                               .point(ask.numbers_written("reference").at(0))
                               .distance(Edge::right);
    }
    if (ask.has("process_zone")) {
        const Exact zone = ask.exact("process_zone");
        require_positive(ask, "process_zone", zone,
                         "give the length of the process zone, or leave it out");
        result.process_zone = zone;
    }
    if (ask.has("part")) {
        const auto part = ask.exacts("part");
        const auto sign = [&](const Expr& e) { return sign_of(ask, "part", Exact(e)); };
        if (part.size() != 2 || sign(part[0].value.expr()) < 0 ||
            sign(part[1].value.expr() - part[0].value.expr()) <= 0 ||
            sign(whole(1) - part[1].value.expr()) < 0) {
            ask.reject("part", "the part of the contact does not ascend within 0 ... 1",
                       "write part = [\"0\", \"1/2\"], fractions of a + b from the edge");
        }
        if (result.process_zone && part[0].value.sign() != 0) {
            ask.reject("part", "a process zone begins at the edge, and this part does not",
                       "write part = [\"0\", \"...\"], or leave process_zone out");
        }
        result.part = {part[0].value, part[1].value};
    }
    if (ask.has("route")) {
        result.route = route_of(ask, scene);
    }
    if (ask.has("quantities")) {
        for (const std::string& name : ask.texts("quantities")) {
            const GroupRow& group = group_of(ask, name);
            if (const auto lack = lack_of(scene, group)) {
                ask.reject("quantities", lack->problem, lack->instead);
            }
            result.quantities.insert(group.group);
        }
    }
}

void default_quantities(Ask& ask, bool shear, bool friction) {
    if (!ask.quantities.empty()) {
        return;
    }
    if (!ask.u.empty()) {
        ask.quantities.insert(QuantityGroup::pressure);
        if (shear) {
            ask.quantities.insert(QuantityGroup::shear);
        }
    }
    // With points and no number of terms, the tolerance is only for figures and other commands.
    if (ask.tolerance && (!ask.terms.empty() || ask.u.empty())) {
        ask.quantities.insert(QuantityGroup::extent);
    }
    if (friction) {
        ask.quantities.insert(QuantityGroup::slip);
    }
    if (!ask.in_bodies.empty()) {
        ask.quantities.insert(QuantityGroup::stress);
    }
    if (ask.quantities.empty()) {
        ask.quantities.insert(QuantityGroup::coefficients);
    }
}

std::size_t Ask::most_terms() const {
    return terms.empty() ? 0 : *std::max_element(terms.begin(), terms.end());
}

Exact parse_tolerance(std::string_view text) {
    const bool percent = !text.empty() && text.back() == '%';
    const Exact given = [&] {
        try {
            return Exact::parse(percent ? text.substr(0, text.size() - 1) : text);
        } catch (const InputError& error) {
            throw InputError("tolerance \"" + std::string(text) + "\": " + error.problem(),
                             "write it as 1%, 0.01 or 1/100");
        }
    }();
    require(given.sign() > 0, "a tolerance of " + std::string(text) + " is not positive",
            "give a tolerance > 0, such as 1%");
    const Exact tolerance = percent ? Exact(given.expr() / whole(100)) : given;
    static const Expr least = Expr::number(parse_decimal("1e-60"));
    static const Expr most = Expr::number(parse_decimal("1e6"));
    require(!is_less(tolerance.expr(), least) && !is_less(most, tolerance.expr()),
            "a tolerance of " + std::string(text) + " is out of range",
            "give one from 1e-60 to 1e6, such as 1%");
    return tolerance;
}

} // namespace edgeproof::scene
