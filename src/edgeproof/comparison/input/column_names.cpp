// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/comparison/input/column_names.hpp"

#include "edgeproof/io/toml/toml_text.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <iterator>

namespace edgeproof::comparison {
namespace {

struct KnownNames {
    std::string_view names;
    ColumnRole role;
    int rank;
};

// Abaqus: COORD1, CPRESS, CSHEAR1; COORD.COOR1 in its reports. ANSYS: CONT,PRES. CalculiX: CONTACT
// STRESS. ParaView: Points:0. ANSYS Workbench: X Location. Code_Aster: COOR_X, LAGS_C. COMSOL:
// solid.Tn.
constexpr KnownNames known_names[] = {
    {"x", ColumnRole::place, 1},
    {"x1 coord1 coor1 coordcoor1 xcoord xcoordinate coordx coordinatex xcoor xpos xposition xloc "
     "xlocation coorx",
     ColumnRole::place, 2},
    {"points0 pointsx", ColumnRole::place, 3},
    {"position pos coordinate coord", ColumnRole::place, 4},
    {"distance truedistancealongpath", ColumnRole::place, 5},
    {"arclength", ColumnRole::place, 6},
    {"s", ColumnRole::place, 7},
    {"r radius", ColumnRole::place, 8},
    {"p cpress pressure contactpressure contpres contpress", ColumnRole::pressure, 1},
    {"pcontact normalpressure contactstress normaltraction tractionnormal normalstress",
     ColumnRole::pressure, 2},
    {"tn pn pres press solidtn lagsc", ColumnRole::pressure, 3},
    {"druck kontaktdruck pression pressiondecontact pressione pressionedicontatto presin presion",
     ColumnRole::pressure, 3}, // German, French, Italian, Spanish
    {"sigman sn", ColumnRole::pressure, 4},
    {"s22 sy syy sigmayy sigmay", ColumnRole::pressure, 5},
    {"q cshear1 cshear", ColumnRole::shear, 1},
    {"shear sheartraction tangentialtraction", ColumnRole::shear, 2},
    {"contsfri", ColumnRole::shear, 3},
    {"tt tau", ColumnRole::shear, 4},
    {"copen gap contgap", ColumnRole::gap, 1},
    {"cslip1 cslip slip contslid", ColumnRole::slip, 1},
    {"s11 sxx sigmaxx sx", ColumnRole::sxx, 1},
};

constexpr std::string_view other_names =
    "node nodelabel nodenumber nodeno nodeid element elem elementlabel elementnumber elementid "
    "label number no id partinstance partinstancename y z ycoord ycoordinate zcoord zcoordinate "
    "coordinatey coordinatez cstatus status ylocation zlocation noeud coory coorz yposition "
    "zposition knoten knotennummer knotennr";
/// Columns that number the steps of a computation, or give their time; a step has increments.
constexpr std::string_view step_names =
    "step stepnumber stepid loadstep substep increment inc frame numordre time steptime inst";
constexpr std::size_t most_words_of_a_name = 4; // for example "True distance along path"
constexpr std::size_t most_words_of_a_header = 64;

std::string plain_of(std::string_view text) {
    std::string out = lower_case(text);
    std::erase_if(out, [](char c) { return (c < 'a' || c > 'z') && (c < '0' || c > '9'); });
    return out;
}

bool has_word(std::string_view words, std::string_view word) {
    const std::vector<std::string_view> all = io::split_words(words);
    return std::ranges::find(all, word) != all.end();
}

} // namespace

std::optional<int> step_rank(std::string_view plain_name) {
    const std::vector<std::string_view> all = io::split_words(step_names);
    const auto found = std::ranges::find(all, plain_name);
    return found == all.end() ? std::nullopt : std::optional(static_cast<int>(found - all.begin()));
}

namespace {

bool is_known(const std::string& written) {
    const std::string plain = read_column_name(written).plain;
    return role_of(plain).has_value() || step_rank(plain) || has_word(other_names, plain);
}

/// True for a word that does not occur in prose.
bool is_symbol(std::string_view word) {
    return word.find_first_of("0123456789._:") != std::string_view::npos;
}

} // namespace

ColumnName read_column_name(std::string_view written) {
    written = trimmed(written);
    ColumnName name;
    const std::size_t open = written.find_first_of("[(<");
    if (open != std::string_view::npos && open > 0) {
        const std::size_t close = written.find_first_of("])>", open);
        const std::string_view inside = trimmed(
            written.substr(open + 1, close == std::string_view::npos ? close : close - open - 1));
        name.plain = plain_of(written.substr(0, open));
        name.unit = scene::unit_named(inside);
        name.unread = name.unit || inside == "-" || inside == "1" ? "" : std::string(inside);
        return name;
    }
    for (const std::string_view before : {"/", "_", ",", " in ", " "}) {
        const std::size_t at = before == "/" ? written.find(before) : written.rfind(before);
        if (at == std::string_view::npos || at == 0) {
            continue;
        }
        const std::string_view after = trimmed(written.substr(at + before.size()));
        auto unit = scene::unit_named(after);
        if (unit || scene::resembles_unit(after)) {
            name.plain = plain_of(written.substr(0, at));
            name.unread = unit ? "" : std::string(after);
            name.unit = std::move(unit);
            return name;
        }
    }
    name.plain = plain_of(written);
    return name;
}

std::optional<NamedRole> role_of(std::string_view plain_name) {
    const auto found = std::ranges::find_if(
        known_names, [&](const KnownNames& known) { return has_word(known.names, plain_name); });
    return found == std::end(known_names) ? std::nullopt
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
        const std::string_view part = trimmed(text.substr(at, comma - at));
        const std::size_t equals = std::min(part.find('='), part.size());
        const std::string_view key = trimmed(part.substr(0, equals));
        const std::string_view value = trimmed(part.substr(std::min(equals + 1, part.size())));
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
