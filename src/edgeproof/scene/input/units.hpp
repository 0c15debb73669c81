// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/io/toml/toml_section.hpp"
#include "edgeproof/precision/real.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace edgeproof::scene {

/// A unit by its usual name; `factor` is its exact value in the SI unit (m, N, Pa).
struct Unit {
    enum class Dimension { length, force, pressure };
    std::string name;
    Rational factor;
    Dimension dimension = Dimension::length;
};

/// Finds a unit: m, N and Pa with the SI prefixes (mm, kN, MPa; u or a micro sign for 10^-6), in,
/// ft, lbf, kgf, psi, ksi, bar, and a force over the square of a length (N/mm^2, N/mm2, kgf/mm2).
/// Case matters: MPa is not mPa. The inch is 25.4 mm, the pound-force 4.4482216152605 N, the
/// kilogram-force 9.80665 N (BIPM, NIST SP 811). Returns nothing for other names.
[[nodiscard]] std::optional<Unit> unit_named(std::string_view name);

/// True for a text that is meant as a unit, and is none of unit_named(): the name of one in other
/// letters (KPa, MPA), in words (inches), or of another system (atm).
[[nodiscard]] bool resembles_unit(std::string_view name);

/// The units of a scene's numbers. They are labels: no number of the scene is converted.
struct Units {
    std::optional<Unit> length;
    std::optional<Unit> force; ///< P is in this unit per unit of length
    std::optional<Unit> pressure;

    /// Returns "lengths in mm, P in N/mm, M in N, pressures in MPa", as far as the units are known.
    [[nodiscard]] std::string text(bool axisymmetric = false) const;
};

/// Returns " [mm]", or nothing: for the name of a column or an axis.
[[nodiscard]] std::string unit_label(const std::optional<Unit>& unit);

/// Reads [units]. Throws InputError for an unknown unit, for one of another dimension, and for
/// three that are not consistent: the pressure unit times the square of the length unit must be the
/// force unit, otherwise P and p of the scene would not be in these units.
[[nodiscard]] Units read_units(const io::TomlSection& section);

} // namespace edgeproof::scene
