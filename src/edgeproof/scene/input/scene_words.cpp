// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/scene/input/scene_words.hpp"

#include "edgeproof/io/text_file.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/message.hpp"
#include "edgeproof/precision/rounding/text.hpp"
#include "edgeproof/scene/input/readers.hpp"

#include <algorithm>
#include <filesystem>
#include <iterator>

namespace edgeproof::scene {
namespace {

/// The keys of each section that have one value or a list (with a star), and no number (a colon).
constexpr std::pair<std::string_view, const char*> keys_of_sections[] = {
    {"profile", "kind: geometry: m C phi alpha t flat_width R R1 R2 knots* slopes*: symmetric:"},
    {"load", "a width P delta M contact_modulus E nu E1 nu1 E2 nu2"},
    {"shear", "Q q_ratio bulk_tension bulk_A path: sliding: friction"},
    {"ask", "edges*: u* x* terms* tolerance process_zone quantities*: reference part* route: "
            "digits"},
    {"units", "length: force: pressure:"}};

io::TomlEntry entry_of(const Key& key, const std::string& value) {
    const std::string name(key.name);
    if (name == "edges" && value == "both") {
        return {name, std::vector<std::string>{"right", "left"}};
    }
    if (name == "symmetric") {
        return {name, value != "false"};
    }
    const std::size_t dots = value.find("..");
    const bool range = dots != std::string::npos && dots > 0 && dots + 2 < value.size();
    if (range && (name == "u" || name == "x")) {
        const std::size_t colon = std::min(value.find(':', dots), value.size());
        const std::string points = colon < value.size() ? value.substr(colon + 1) : "21";
        require(!points.empty() && points.size() < 7 &&
                    points.find_first_not_of("0123456789") == std::string::npos,
                name + "=" + value + ": '" + points + "' is no number of points",
                "write " + name + "=FROM..TO:POINTS, such as " + name + "=-1..1:21");
        return {name, io::TomlRange{value.substr(0, dots), value.substr(dots + 2, colon - dots - 2),
                                    std::stol(points)}};
    }
    if (key.list && !value.empty()) {
        return {name, parts_of(value)};
    }
    if (range) {
        return {name, io::TomlRange{value.substr(0, dots), value.substr(dots + 2)}};
    }
    if (name == "tolerance") {
        refuse_whole_tolerance("tolerance =", value);
    }
    return {name, value};
}

} // namespace

void refuse_whole_tolerance(const std::string& option, const std::string& text) {
    if (text.empty() || text.back() == '%' ||
        text.find_first_not_of("0123456789.") != std::string::npos) {
        return;
    }
    const Rational given = parse_decimal(text);
    require(given < 1, option + " " + text + " is " + exact_text(Rational(given * 100)) + " %",
            "write " + text + "% or " + exact_text(Rational(given / 100)));
}

std::vector<std::string> parts_of(const std::string& text) {
    std::vector<std::string> parts;
    for (std::size_t at = 0; at <= text.size();) {
        const std::size_t comma = std::min(text.find(',', at), text.size());
        parts.push_back(text.substr(at, comma - at));
        at = comma + 1;
    }
    return parts;
}

const std::vector<Key>& keys_of_scene() {
    static const std::vector<Key> all = [] {
        std::vector<Key> made;
        for (const auto& [section, names] : keys_of_sections) {
            for (const std::string_view name : io::split_words(names)) {
                made.push_back({name.substr(0, name.find_first_of("*:")), section,
                                name.find('*') != name.npos, name.back() == ':'});
            }
        }
        return made;
    }();
    return all;
}

const Key* key_named(std::string_view name) {
    const auto found = std::ranges::find(keys_of_scene(), name, &Key::name);
    return found == keys_of_scene().end() ? nullptr : &*found;
}

std::vector<std::string_view> keys_of_section(std::string_view section) {
    std::vector<std::string_view> names;
    for (const Key& key : keys_of_scene()) {
        if (key.section == section) {
            names.push_back(key.name);
        }
    }
    return names;
}

std::size_t key_length(const std::string& word) {
    const std::size_t equals = word.find('=');
    std::error_code failed;
    const bool is_key =
        equals != std::string::npos && equals > 0 &&
        std::all_of(word.begin(), word.begin() + static_cast<std::ptrdiff_t>(equals),
                    [](unsigned char c) { return std::isalnum(c) != 0 || c == '_' || c == '*'; }) &&
        !std::filesystem::is_regular_file(word, failed);
    return is_key ? equals : std::string::npos;
}

std::string value_of(const std::vector<std::string>& words, std::string_view key) {
    std::string value;
    for (const std::string& word : words) {
        const std::size_t length = key_length(word);
        if (length != std::string::npos && word.substr(0, length) == key) {
            value += (value.empty() ? "" : ",") + word.substr(length + 1);
        }
    }
    return value;
}

GivenScene given_scene(const std::vector<std::string>& words) {
    GivenScene given;
    std::map<std::string_view, std::vector<io::TomlEntry>> entries; // by section
    for (const std::string& word : words) {
        const std::size_t length = key_length(word);
        if (length == std::string::npos) {
            require(given.file.empty(), "there are two scenes, " + given.file + " and " + word,
                    "give one file, and key=value for what differs");
            given.file = word;
            continue;
        }
        const std::string name = word.substr(0, length);
        const Key* const key = key_named(name);
        if (key == nullptr) {
            std::vector<std::string_view> names;
            std::ranges::transform(keys_of_scene(), std::back_inserter(names), &Key::name);
            throw InputError("there is no key '" + name + "' of a scene", one_of(name, names));
        }
        io::TomlEntry entry = entry_of(*key, word.substr(length + 1));
        auto& of_section = entries[key->section];
        const auto same = std::ranges::find(of_section, name, &io::TomlEntry::key);
        if (same == of_section.end()) {
            of_section.insert(name == "kind" ? of_section.begin() : of_section.end(),
                              std::move(entry));
        } else if (key->list) {
            auto& list = std::get<std::vector<std::string>>(same->value);
            const auto& more = std::get<std::vector<std::string>>(entry.value);
            list.insert(list.end(), more.begin(), more.end());
        } else {
            throw InputError(name + " is given twice", "give one value");
        }
    }
    auto& ask = entries["ask"];
    for (const auto& [place, other] : {std::pair{"u", "x"}, std::pair{"x", "u"}}) {
        if (!given.file.empty() && std::ranges::count(ask, place, &io::TomlEntry::key) > 0 &&
            std::ranges::count(ask, other, &io::TomlEntry::key) == 0) {
            ask.push_back({other, std::string()}); // the points of the words replace all others
            break;
        }
    }
    for (const auto& [section, names] : keys_of_sections) {
        const bool needed = section == "profile" || section == "load";
        if (!entries[section].empty() || (given.file.empty() && needed && !words.empty())) {
            given.instead.push_back({std::string(section), 0, std::move(entries[section])});
        }
    }
    require(!given.file.empty() || !given.instead.empty(), "no scene is given",
            "name its file, - for standard input, or give its "
            "keys: kind=hertz R=100 P=120 ...");
    return given;
}

AskedValue asked_value(std::string_view quantity, const std::map<std::string, std::string>& where,
                       const Place::Names& names) {
    const auto named = column_named(quantity);
    if (!named) {
        throw InputError("there is no quantity '" + std::string(quantity) + "'",
                         quantity_advice(quantity));
    }
    const auto given = [&](const char* key) {
        const auto found = where.find(key);
        return found == where.end() ? std::optional<std::string>() : found->second;
    };
    const auto missing = [&](const std::string& keys) {
        throw InputError(std::string(quantity) + " has a place", "add " + keys);
    };
    AskedValue asked{named->quantity, named->k};
    const QuantityRow& row = row_of(asked.quantity);
    asked.edge = edge_of(given("edge").value_or("right"));
    const Body body = body_named(given("body").value_or("A"));
    const auto place = [&](const std::string& text, Place::From from) {
        return Place::parse(text, from, names).distance(asked.edge);
    };
    if (row.at_point() || row.place == QuantityRow::Place::surface) {
        const auto x = given("x");
        const auto u = given("u");
        if (x) {
            asked.place = place(*x, Place::From::origin);
        } else if (u && row.at_point()) {
            asked.place = place(*u, Place::From::edge);
            asked.u = asked.place->number();
        } else {
            missing(row.at_point() ? "u=, the distance from the edge, or x=" : "x=");
        }
    }
    if (row.place == QuantityRow::Place::body) {
        const std::vector<std::string> both = parts_of(given("at").value_or(""));
        if (both.size() != 2) {
            missing("at=X,Z, the place and the depth");
        }
        asked.in_body = body_point(both[0], both[1], body, names);
    } else if (row.place == QuantityRow::Place::surface) {
        asked.in_body = {Exact(), Exact(), body};
        asked.reference = place(given("reference").value_or("0"), Place::From::origin);
    }
    if (row.tolerance) {
        asked.tolerance = parse_tolerance(given("tolerance").value_or("1%"));
    }
    return asked;
}

} // namespace edgeproof::scene
