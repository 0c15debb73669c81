// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/scene/input/read_places.hpp"

#include "edgeproof/formula/parse.hpp"
#include "edgeproof/io/error_place.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/scene/input/points.hpp"
#include "edgeproof/scene/input/read_ask.hpp"

#include <cctype>
#include <string>

namespace edgeproof::scene {
namespace {

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
            return inside(
                {with_line(item, [&] { return formula::Exact::parse(item.text); }), item.line});
        }
        const Place place = with_line(item, [&] { return Place::parse(item.text, from_, names_); });
        const auto number = with_line(item, [&] { return place.number(); });
        return from_ == Place::From::edge && number
                   ? inside({*number, item.line, {}, item.text})
                   : AskedPoint{formula::Exact(), item.line, place};
    }
    [[nodiscard]] formula::Exact number(std::string_view end) const {
        const io::TomlSection::Written item = section_.numbers_written(end).at(0);
        if (!has_names(item.text)) {
            return section_.exact(end);
        }
        const auto number =
            with_line(item, [&] { return Place::parse(item.text, from_, names_).number(); });
        if (!number) {
            section_.reject(item.line,
                            std::string(end) + " = " + item.text +
                                " is not a number: it depends on a and b, which are unknown",
                            "give a number, or a list of places");
        }
        return *number;
    }
    [[nodiscard]] AskedPoint inside(AskedPoint point) const {
        if (sign_of(section_, key_, point.u) <= 0) {
            section_.reject(point.line, "u = " + point.u.text() + " is not inside the contact",
                            "give distances from the edge, 0 < u < a + b");
        }
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
    const io::TomlSection range = ask.section(key);
    const bool by_x = from == Place::From::origin;
    const std::size_t line = ask.line(key);
    range.allow(by_x ? std::vector<std::string_view>{"from", "to", "points"}
                     : std::vector<std::string_view>{"from", "to", "per_decade", "points"});
    if (range.has("per_decade") == range.has("points")) {
        ask.reject(line,
                   by_x ? "a range of x needs points"
                        : "a range of u needs one of per_decade and points",
                   by_x ? "write x = { from = \"-0.5\", to = \"0.5\", points = 11 }"
                        : "write u = { from = \"1e-12\", to = \"0.9\", per_decade = 5 }");
    }
    const PlaceReader reader(range, by_x ? "x" : "from", from, names);
    io::at_place(ask.file(), line, [&] {
        const formula::Exact begin = reader.number("from");
        const formula::Exact end = reader.number("to");
        if (!by_x) {
            (void)reader.inside({begin, line});
        }
        const PointRange points_between =
            range.has("per_decade")
                ? PointRange::geometric(begin, end, range.count("per_decade", 1, 10'000))
                : PointRange::even(begin, end, range.count("points", 2, 100'000));
        for (const formula::Exact& u : points_between.all()) {
            points.push_back(
                by_x ? AskedPoint{formula::Exact(), line, Place::parse(u.text(), from, names)}
                     : AskedPoint{u, line});
        }
    });
}

} // namespace

Place::Names names_of(const io::TomlSection& profile, const Scene& scene) {
    Place::Names names;
    if (scene.profile) {
        for (const auto& [name, value] : scene.profile->parameters()) {
            names.insert_or_assign(name, value.expr());
        }
    }
    for (const std::string& key : profile.keys()) {
        if (key != "kind" && key != "knots" && key != "slopes" && key != "symmetric") {
            names.insert_or_assign(key, profile.exact(key).expr());
        }
    }
    if (scene.load.kind == contact::Load::Kind::right_edge) {
        names.insert_or_assign("a", scene.load.value.expr());
    }
    if (scene.symmetric()) {
        const auto a = names.find("a");
        names.insert_or_assign("b", a != names.end() ? a->second : formula::Expr::symbol("a"));
    }
    return names;
}

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

} // namespace edgeproof::scene
