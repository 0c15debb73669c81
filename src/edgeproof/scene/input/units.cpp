// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/scene/input/units.hpp"
#include "edgeproof/precision/message.hpp"
#include "edgeproof/scene/input/scene_words.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

namespace edgeproof::scene {
namespace {

struct NamedFactor {
    std::string_view name;
    const char* factor; ///< as a quotient
};

constexpr std::array prefixes{
    NamedFactor{"", "1"},
    NamedFactor{"p", "1/1000000000000"},
    NamedFactor{"n", "1/1000000000"},
    NamedFactor{"u", "1/1000000"},
    NamedFactor{"\xC2\xB5", "1/1000000"}, // the micro sign
    NamedFactor{"\xCE\xBC", "1/1000000"}, // the Greek letter
    NamedFactor{"m", "1/1000"},
    NamedFactor{"c", "1/100"},
    NamedFactor{"d", "1/10"},
    NamedFactor{"h", "100"},
    NamedFactor{"k", "1000"},
    NamedFactor{"M", "1000000"},
    NamedFactor{"G", "1000000000"},
    NamedFactor{"T", "1000000000000"},
};

struct OtherUnit : NamedFactor {
    Unit::Dimension dimension;
};

constexpr std::array other_units{
    OtherUnit{{"in", "127/5000"}, Unit::Dimension::length},
    OtherUnit{{"inch", "127/5000"}, Unit::Dimension::length},
    OtherUnit{{"ft", "381/1250"}, Unit::Dimension::length},
    OtherUnit{{"lbf", "8896443230521/2000000000000"}, Unit::Dimension::force},
    OtherUnit{{"kgf", "196133/20000"}, Unit::Dimension::force},
    OtherUnit{{"bar", "100000"}, Unit::Dimension::pressure},
    OtherUnit{{"psi", "8896443230521/1290320000"}, Unit::Dimension::pressure}, // lbf/in^2
    OtherUnit{{"ksi", "8896443230521/1290320"}, Unit::Dimension::pressure},
};

constexpr std::array<std::pair<std::string_view, Unit::Dimension>, 3> si_units{
    {{"m", Unit::Dimension::length},
     {"N", Unit::Dimension::force},
     {"Pa", Unit::Dimension::pressure}}};

std::optional<Unit> plain_unit(std::string_view name) {
    for (const auto& [si, dimension] : si_units) {
        if (name.ends_with(si)) {
            const std::string_view before = name.substr(0, name.size() - si.size());
            for (const NamedFactor& prefix : prefixes) {
                if (before == prefix.name) {
                    return Unit{std::string(name), Rational(prefix.factor), dimension};
                }
            }
        }
    }
    for (const OtherUnit& unit : other_units) {
        if (name == unit.name) {
            return Unit{std::string(name), Rational(unit.factor), unit.dimension};
        }
    }
    return {};
}

/// Reads "N/mm^2", "N/mm2", "N/mm**2", and the form with a superscript two.
std::optional<Unit> force_over_area(std::string_view name) {
    const std::size_t slash = name.find('/');
    if (slash == std::string_view::npos) {
        return {};
    }
    for (const std::string_view square : {"**2", "^2", "\xC2\xB2", "2"}) {
        if (!name.ends_with(square)) {
            continue;
        }
        const auto force = plain_unit(name.substr(0, slash));
        const auto length =
            plain_unit(name.substr(slash + 1, name.size() - slash - 1 - square.size()));
        if (force && length && force->dimension == Unit::Dimension::force &&
            length->dimension == Unit::Dimension::length) {
            return Unit{std::string(name),
                        Rational(force->factor / (length->factor * length->factor)),
                        Unit::Dimension::pressure};
        }
        return {};
    }
    return {};
}

} // namespace

std::optional<Unit> unit_named(std::string_view name) {
    auto unit = plain_unit(name);
    return unit ? unit : force_over_area(name);
}

bool resembles_unit(std::string_view name) {
    static const std::set<std::string> resembling = [] {
        std::set<std::string> names{"inches",     "feet",        "meter",      "meters",
                                    "metre",      "metres",      "millimeter", "millimeters",
                                    "millimetre", "millimetres", "micron",     "microns",
                                    "atm",        "torr",        "mmhg",       "psf",
                                    "msi",        "pascal",      "megapascal"};
        for (const OtherUnit& unit : other_units) {
            names.insert(lower_case(unit.name));
        }
        for (const auto& [si, dimension] : si_units) {
            for (const NamedFactor& prefix : prefixes) {
                names.insert(lower_case(std::string(prefix.name) + std::string(si)));
            }
        }
        return names;
    }();
    return !unit_named(name) && resembling.contains(lower_case(name));
}

std::string unit_label(const std::optional<Unit>& unit) {
    return unit ? " [" + unit->name + "]" : "";
}

std::string Units::text(bool axisymmetric) const {
    std::string out;
    const auto add = [&out](const std::string& what) { out += (out.empty() ? "" : ", ") + what; };
    if (length) {
        add("lengths in " + length->name);
    }
    if (force && axisymmetric) {
        add("P in " + force->name);
    } else if (force && length) {
        add("P in " + force->name + "/" + length->name);
    }
    if (force && !axisymmetric) {
        add("M in " + force->name);
    }
    if (pressure) {
        add("pressures in " + pressure->name);
    }
    return out;
}

Units read_units(const io::TomlSection& section) {
    section.allow(keys_of_section("units"));
    Units units;
    const auto read = [&](std::string_view key, Unit::Dimension dimension, const char* examples) {
        std::optional<Unit> unit;
        if (section.has(key)) {
            const std::string name = section.text(key);
            unit = unit_named(name);
            if (!unit || unit->dimension != dimension) {
                section.reject(
                    key, "'" + name + "' is no unit of " + std::string(key) + " that is known",
                    examples);
            }
        }
        return unit;
    };
    units.length = read("length", Unit::Dimension::length, "write one such as m, mm, um or in");
    units.force = read("force", Unit::Dimension::force, "write one such as N, kN or lbf");
    units.pressure =
        read("pressure", Unit::Dimension::pressure, "write one such as Pa, MPa, N/mm^2 or psi");
    if (units.length && units.force && units.pressure &&
        units.pressure->factor * units.length->factor * units.length->factor !=
            units.force->factor) {
        section.reject(
            section.line("pressure"),
            units.pressure->name + " times " + units.length->name + " squared is not " +
                units.force->name + ": the units of force, length and pressure are not consistent",
            "write consistent units, such as mm, N and MPa, or m, N and Pa; or leave one "
            "of them out");
    }
    return units;
}

} // namespace edgeproof::scene
