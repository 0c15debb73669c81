// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/io/toml/toml_section.hpp"
#include "edgeproof/precision/rational.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace edgeproof::scene {

/// A unit by its usual name, exactly: so many of the SI unit (m, N, Pa).
struct Unit {
    enum class Dimension { length, force, pressure };
    std::string name;
    Rational factor;
    Dimension dimension = Dimension::length;
};

/// m, N and Pa with the SI prefixes (mm, kN, MPa; u or a micro sign for 10^-6), in, ft, lbf, kgf,
/// psi, ksi, bar, and a force over the square of a length (N/mm^2, N/mm2, kgf/mm2). Case counts:
/// MPa is not mPa. The inch is 25.4 mm, the pound-force 4.4482216152605 N, the kilogram-force
/// 9.80665 N (BIPM, NIST SP 811). Nothing for other names.
[[nodiscard]] std::optional<Unit> unit_named(std::string_view name);

/// The units that a scene's numbers are in. Labels: no number of the scene is converted.
struct Units {
    std::optional<Unit> length;
    std::optional<Unit> force; ///< P is so much per unit of length
    std::optional<Unit> pressure;

    /// "lengths in mm, P in N/mm, M in N, pressures in MPa": what is known of it.
    [[nodiscard]] std::string text() const;
};

/// " [mm]", or nothing: behind the name of a column, or on an axis.
[[nodiscard]] std::string unit_label(const std::optional<Unit>& unit);

/// Reads [units]. Throws InputError for a unit that is not known, one of another dimension, and for
/// three that do not go together: a pressure unit times the square of the length unit is the force
/// unit, or P and p of the scene would not be in them.
[[nodiscard]] Units read_units(const io::TomlSection& section);

} // namespace edgeproof::scene
