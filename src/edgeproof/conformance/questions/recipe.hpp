// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/conformance/questions/question.hpp"

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace edgeproof::conformance {

/// The description of a reference table: contacts with grids of parameters, and the questions for
/// each.
///
///     title = "Wedge, Hertz and beyond"
///     digits = 50
///     rounding = "nearest"
///     [scenes.hertz]                    # any name: ids begin with it
///     edges = ["right", "left"]
///     u = ["1e-30", "0.1"]              # or { from, to, per_decade } or { from, to, points }
///     quantities = ["p", "c_0", "P"]    # p, q, c_k, s_k, a, b, P, M, alpha, extent_k, measure_k
///     tolerance = ["1%", "5%"]          # of extents
///     [scenes.hertz.profile]            # as in a scene, but a list or a range is a grid of values
///     kind = "power-law"
///     m = ["1", "2"]
///     C = "1"
///     [scenes.hertz.load]
///     a = "1"
///     contact_modulus = "1"
///
/// The id of a question consists of the scene's name, the parameters given as a grid, the edge, u
/// and the quantity ("hertz:m=2:right:u=0.1:p"); it does not change when the recipe grows. Order:
/// scenes as in the file; grids with the last key varying fastest; for each contact first the
/// quantities without an edge, then for each edge coefficients, extents by tolerance, and the
/// points; quantities as listed.
struct Recipe {
    std::string file;
    std::string title;
    scene::Digits digits; ///< with binary64
    Questions questions;
};

/// Throws InputError with file and line for malformed input: unknown keys and names, empty grids,
/// ids that occur twice, a question that the contact cannot answer, more than a million questions.
[[nodiscard]] Recipe read_recipe(const std::filesystem::path& file);
[[nodiscard]] Recipe parse_recipe(std::string_view text, const std::string& file);

} // namespace edgeproof::conformance
