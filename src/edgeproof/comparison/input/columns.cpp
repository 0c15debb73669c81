// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/comparison/input/result_lines.hpp"
#include "edgeproof/comparison/input/result_table.hpp"
#include "edgeproof/io/foreign_text.hpp"
#include "edgeproof/io/text_file.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/message.hpp"
#include "edgeproof/scene/input/scene_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
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

/// Columns that number the steps of a computation, or give their time; a step has increments.
constexpr std::string_view step_names =
    "step stepnumber stepid loadstep substep increment inc frame numordre time steptime inst";

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

namespace {

/// A part KEY=VALUE of the text of an option.
struct Choice {
    std::string part;
    std::string key;
    std::string value;
};
std::vector<Choice> choices_in(const std::string& text) {
    std::vector<Choice> choices;
    for (const std::string& part :
         text.empty() ? std::vector<std::string>{} : scene::parts_of(text)) {
        const std::size_t equals = std::min(part.find('='), part.size());
        choices.push_back({std::string(trimmed(part)), std::string(trimmed(part.substr(0, equals))),
                           std::string(trimmed(part.substr(std::min(equals + 1, part.size()))))});
    }
    return choices;
}

} // namespace

ResultReading reading_of(const std::optional<scene::Units>& units, const std::string& columns,
                         const std::string& scale) {
    ResultReading reading;
    reading.units = units;
    for (const auto& [part, key, value] : choices_in(columns)) {
        const bool twice = reading.columns.contains(key);
        if (twice || value.empty() || (key != "x" && key != "p" && key != "q")) {
            throw InputError("--columns " + columns + ": '" + part +
                                 "' does not name a column of x, p or q" +
                                 (twice ? " that is not named already" : ""),
                             "write it as x=1,p=3, by number from 1 or by name");
        }
        reading.columns.emplace(key, value);
    }
    for (const auto& [part, key, value] : choices_in(scale)) {
        const auto factor = io::read_number(value);
        if ((key != "x" && key != "p") || !factor || !(*factor > 0)) {
            throw InputError("--scale " + scale + ": '" + part + "' is no factor of x or p",
                             "write it as x=1e-3,p=1e6, with positive factors");
        }
        (key == "x" ? reading.x_scale : reading.p_scale) = factor;
    }
    return reading;
}

// The digits with which the numbers of a column are written.

using io::DecimalForm;
using io::form_of;

std::vector<double> column_rounding(const std::vector<std::string_view>& column) {
    std::vector<DecimalForm> forms;
    forms.reserve(column.size());
    int significant = 0;
    int decimals = 0;
    bool exponents = false;
    for (const std::string_view text : column) {
        forms.push_back(form_of(text));
        significant = std::max(significant, forms.back().significant);
        decimals = std::max(decimals, forms.back().decimals);
        exponents = exponents || forms.back().with_exponent;
    }
    std::vector<double> half;
    half.reserve(forms.size());
    for (const DecimalForm& form : forms) {
        const int last = exponents ? form.leading - significant + 1 : -decimals;
        half.push_back(form.exact || (exponents && form.zero) ? 0 : 0.5 * std::pow(10.0, last));
    }
    return half;
}

} // namespace edgeproof::comparison
