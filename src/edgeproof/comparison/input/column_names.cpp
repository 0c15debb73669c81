// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/comparison/input/column_names.hpp"

#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <array>

namespace edgeproof::comparison {
namespace {

struct KnownName {
    std::string_view plain;
    ColumnRole role;
    int rank;
};

// Abaqus: COORD1, CPRESS, CSHEAR1. ANSYS: CONT,PRES. CalculiX: CONTACT STRESS. ParaView: Points:0.
constexpr std::array known_names{
    KnownName{"x", ColumnRole::place, 1},
    KnownName{"x1", ColumnRole::place, 2},
    KnownName{"coord1", ColumnRole::place, 2},
    KnownName{"coor1", ColumnRole::place, 2},
    KnownName{"coordcoor1", ColumnRole::place, 2}, // COORD.COOR1 of a report of Abaqus
    KnownName{"xcoord", ColumnRole::place, 2},
    KnownName{"xcoordinate", ColumnRole::place, 2},
    KnownName{"coordx", ColumnRole::place, 2},
    KnownName{"coordinatex", ColumnRole::place, 2},
    KnownName{"xcoor", ColumnRole::place, 2},
    KnownName{"xpos", ColumnRole::place, 2},
    KnownName{"xposition", ColumnRole::place, 2},
    KnownName{"xloc", ColumnRole::place, 2},
    KnownName{"points0", ColumnRole::place, 3},
    KnownName{"pointsx", ColumnRole::place, 3},
    KnownName{"position", ColumnRole::place, 4},
    KnownName{"pos", ColumnRole::place, 4},
    KnownName{"coordinate", ColumnRole::place, 4},
    KnownName{"coord", ColumnRole::place, 4},
    KnownName{"distance", ColumnRole::place, 5},
    KnownName{"truedistancealongpath", ColumnRole::place, 5},
    KnownName{"arclength", ColumnRole::place, 6},
    KnownName{"s", ColumnRole::place, 7},
    KnownName{"p", ColumnRole::pressure, 1},
    KnownName{"cpress", ColumnRole::pressure, 1},
    KnownName{"pressure", ColumnRole::pressure, 1},
    KnownName{"contactpressure", ColumnRole::pressure, 1},
    KnownName{"contpres", ColumnRole::pressure, 1},
    KnownName{"contpress", ColumnRole::pressure, 1},
    KnownName{"pcontact", ColumnRole::pressure, 2},
    KnownName{"normalpressure", ColumnRole::pressure, 2},
    KnownName{"contactstress", ColumnRole::pressure, 2},
    KnownName{"normaltraction", ColumnRole::pressure, 2},
    KnownName{"tractionnormal", ColumnRole::pressure, 2},
    KnownName{"normalstress", ColumnRole::pressure, 2},
    KnownName{"tn", ColumnRole::pressure, 3},
    KnownName{"pn", ColumnRole::pressure, 3},
    KnownName{"pres", ColumnRole::pressure, 3},
    KnownName{"press", ColumnRole::pressure, 3},
    KnownName{"sigman", ColumnRole::pressure, 4},
    KnownName{"sn", ColumnRole::pressure, 4},
    KnownName{"s22", ColumnRole::pressure, 5},
    KnownName{"sy", ColumnRole::pressure, 5},
    KnownName{"syy", ColumnRole::pressure, 5},
    KnownName{"sigmayy", ColumnRole::pressure, 5},
    KnownName{"sigmay", ColumnRole::pressure, 5},
    KnownName{"q", ColumnRole::shear, 1},
    KnownName{"cshear1", ColumnRole::shear, 1},
    KnownName{"cshear", ColumnRole::shear, 1},
    KnownName{"shear", ColumnRole::shear, 2},
    KnownName{"sheartraction", ColumnRole::shear, 2},
    KnownName{"tangentialtraction", ColumnRole::shear, 2},
    KnownName{"contsfri", ColumnRole::shear, 3},
    KnownName{"tt", ColumnRole::shear, 4},
    KnownName{"tau", ColumnRole::shear, 4},
};

constexpr std::array<std::string_view, 28> other_names{"node",
                                                       "nodelabel",
                                                       "nodenumber",
                                                       "nodeno",
                                                       "nodeid",
                                                       "element",
                                                       "elem",
                                                       "elementlabel",
                                                       "elementnumber",
                                                       "elementid",
                                                       "label",
                                                       "number",
                                                       "no",
                                                       "id",
                                                       "partinstance",
                                                       "partinstancename",
                                                       "y",
                                                       "z",
                                                       "ycoord",
                                                       "ycoordinate",
                                                       "zcoord",
                                                       "zcoordinate",
                                                       "coordinatey",
                                                       "coordinatez",
                                                       "cstatus",
                                                       "copen",
                                                       "gap",
                                                       "status"};
constexpr std::size_t most_words_of_a_name = 4; // for example "True distance along path"
constexpr std::size_t most_words_of_a_header = 64;

char lower(char c) { return static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c); }

std::string plain_of(std::string_view text) {
    std::string out;
    for (const char raw : text) {
        const char c = lower(raw);
        if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9')) {
            out += c;
        }
    }
    return out;
}

std::string_view without_blanks(std::string_view text) {
    const std::size_t from = text.find_first_not_of(" \t");
    return from == std::string_view::npos
               ? std::string_view{}
               : text.substr(from, text.find_last_not_of(" \t") - from + 1);
}

bool is_known(const std::string& written) {
    const std::string plain = read_column_name(written).plain;
    return role_of(plain).has_value() || std::ranges::find(other_names, plain) != other_names.end();
}

/// True for a word that does not occur in prose.
bool is_symbol(std::string_view word) {
    return word.find_first_of("0123456789._:") != std::string_view::npos;
}

} // namespace

ColumnName read_column_name(std::string_view written) {
    written = without_blanks(written);
    ColumnName name;
    const std::size_t open = written.find_first_of("[(<");
    if (open != std::string_view::npos && open > 0) {
        const std::size_t close = written.find_first_of("])>", open);
        const std::string_view inside = without_blanks(
            written.substr(open + 1, close == std::string_view::npos ? close : close - open - 1));
        name.plain = plain_of(written.substr(0, open));
        name.unit = scene::unit_named(inside);
        name.unread = name.unit ? "" : std::string(inside);
        return name;
    }
    for (const std::string_view before : {"/", "_", ",", " in ", " "}) {
        const std::size_t at = before == "/" ? written.find(before) : written.rfind(before);
        if (at == std::string_view::npos || at == 0) {
            continue;
        }
        if (auto unit = scene::unit_named(without_blanks(written.substr(at + before.size())))) {
            name.plain = plain_of(written.substr(0, at));
            name.unit = std::move(unit);
            return name;
        }
    }
    name.plain = plain_of(written);
    return name;
}

std::optional<NamedRole> role_of(std::string_view plain_name) {
    const auto found = std::ranges::find(known_names, plain_name, &KnownName::plain);
    return found == known_names.end() ? std::nullopt
                                      : std::optional(NamedRole{found->role, found->rank});
}

std::optional<std::vector<std::string>> names_of_words(const std::vector<std::string>& words,
                                                       std::size_t count) {
    if (words.size() < count || words.size() > most_words_of_a_header) {
        return {};
    }
    struct Way {
        int ways = 0; ///< 2: two or more
        std::string last;
        std::size_t before = 0;
    };
    // ways[k][i]: the ways to divide the first i words into k names.
    std::vector<std::vector<Way>> ways(count + 1, std::vector<Way>(words.size() + 1));
    ways[0][0].ways = 1;
    for (std::size_t k = 0; k < count; ++k) {
        for (std::size_t i = 0; i < words.size(); ++i) {
            std::string name;
            const std::size_t most = std::min(words.size(), i + most_words_of_a_name);
            for (std::size_t end = i + 1; ways[k][i].ways > 0 && end <= most; ++end) {
                if (name.find_first_of("[(<") != std::string::npos) {
                    break; // a unit ends a name
                }
                name += (name.empty() ? "" : " ") + words[end - 1];
                if (is_known(name) || (end == i + 1 && is_symbol(name))) {
                    Way& to = ways[k + 1][end];
                    to = {std::min(2, to.ways + ways[k][i].ways), name, i};
                }
            }
        }
    }
    if (ways[count][words.size()].ways != 1) {
        return {};
    }
    std::vector<std::string> names(count);
    for (std::size_t k = count, i = words.size(); k > 0; --k) {
        names[k - 1] = ways[k][i].last;
        i = ways[k][i].before;
    }
    return names;
}

ColumnChoice parse_columns(std::string_view text) {
    ColumnChoice choice;
    for (std::size_t at = 0; at <= text.size();) {
        const std::size_t comma = std::min(text.find(',', at), text.size());
        const std::string_view part = without_blanks(text.substr(at, comma - at));
        const std::size_t equals = part.find('=');
        const std::string_view key = without_blanks(part.substr(0, std::min(equals, part.size())));
        const std::string value(equals == std::string_view::npos
                                    ? std::string_view{}
                                    : without_blanks(part.substr(equals + 1)));
        std::optional<std::string>* const place = key == "x"   ? &choice.x
                                                  : key == "p" ? &choice.p
                                                  : key == "q" ? &choice.q
                                                               : nullptr;
        if (place == nullptr || value.empty() || *place) {
            throw InputError("--columns " + std::string(text) + ": '" + std::string(part) +
                                 "' does not name a column of x, p or q" +
                                 (place != nullptr && *place ? " that is not named already" : ""),
                             "write it as x=1,p=3, by number from 1 or by name");
        }
        *place = value;
        at = comma + 1;
    }
    return choice;
}

} // namespace edgeproof::comparison
