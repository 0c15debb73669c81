// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/scene/input/quantity.hpp"
#include "edgeproof/scene/input/scene_file.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace edgeproof::validation {

/// A value that is difficult to compute, with the reason.
struct HardCase {
    std::string name;
    std::string family;
    std::string reason; ///< one line
    /// The reason why no ball decides it, if that is impossible; otherwise empty.
    std::string undecided;
    scene::Scene scene;
    scene::AskedValue asked;
    std::size_t line = 0;
};

/// Reads a file of cases:
///
///     [cases.hertz-40]                 # any name
///     class = "u = 1e-40 a"
///     reason = "..."
///     undecided = "..."                # only if no ball can enclose it: the reason
///     quantity = "pressure"            # see scene/route/quantity_rows.cpp
///     edge = "right"
///     u = "1e-40"                      # if the quantity has a place
///     n = 1                            # order of a coefficient, or number of terms
///     tolerance = "1%"                 # of an extent
///     profile = { kind = "power-law", m = "1", C = "1" }   # as in a scene
///     load = { a = "1", contact_modulus = "1" }
///     shear = { Q = "0.3" }            # if there is one
///
/// Throws InputError with file and line for malformed input.
[[nodiscard]] std::vector<HardCase> parse_hard_cases(std::string_view text,
                                                     const std::string& file);

} // namespace edgeproof::validation
